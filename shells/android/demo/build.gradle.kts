plugins {
    alias(libs.plugins.android.application)
    alias(libs.plugins.kotlin.android)
}

android {
    namespace = "org.dogleaf.demo"
    compileSdk = 36
    defaultConfig {
        applicationId = "org.dogleaf.demo"
        minSdk = 26
        targetSdk = 36
        versionCode = 1
        versionName = "0.1.0"
    }
    // The book that comes along.
    sourceSets["main"].assets.srcDir("../../../fixtures/books")
    androidResources.ignoreAssetsPattern = "make:*.cbz:*.md"
    buildTypes["release"].isMinifyEnabled = true
    compileOptions {
        sourceCompatibility = JavaVersion.VERSION_17
        targetCompatibility = JavaVersion.VERSION_17
    }
}

kotlin.jvmToolchain(17)

dependencies {
    implementation(project(":dogleaf"))
}
