plugins {
    alias(libs.plugins.android.library)
    alias(libs.plugins.kotlin.android)
    `maven-publish`
}

group = "org.dogleaf"
version = "0.1.0"

val root = layout.projectDirectory.dir("../../..")

/** What the phone loads, one library an ABI: `cargo install cargo-ndk`, NDK r28 or later (its pages are 16 kB). */
val cargoNdk by tasks.registering(Exec::class) {
    workingDir = root.asFile
    commandLine(
        "cargo", "ndk", "-t", "arm64-v8a", "-t", "armeabi-v7a", "-t", "x86_64", "--platform", "26",
        "-o", layout.projectDirectory.dir("src/main/jniLibs").asFile.path,
        "build", "--profile", "mobile", "-p", "dogleaf-ffi",
    )
    // r27 and before: the same pages by hand.
    environment("RUSTFLAGS", "-C link-arg=-Wl,-z,max-page-size=16384")
}

/** The shaders every GL shell shares, where `Program` looks for them. */
val shaders by tasks.registering(Copy::class) {
    from(root.dir("shells/glsl"))
    into(layout.buildDirectory.dir("shaders/org/dogleaf/glsl"))
}

android {
    namespace = "org.dogleaf"
    compileSdk = 36
    defaultConfig {
        minSdk = 26
        consumerProguardFiles("consumer-rules.pro")
    }
    resourcePrefix = "dogleaf_"
    sourceSets["main"].kotlin.srcDir("src/generated/kotlin")
    sourceSets["main"].resources.srcDir(layout.buildDirectory.dir("shaders"))
    compileOptions {
        sourceCompatibility = JavaVersion.VERSION_17
        targetCompatibility = JavaVersion.VERSION_17
    }
    publishing.singleVariant("release") { withSourcesJar() }
}

kotlin.jvmToolchain(17)

dependencies {
    // The AAR has the native part for phones, the plain jar the one for tests on a JVM.
    api(libs.jna) { artifact { type = "aar" } }
    testImplementation(libs.jna)
    testImplementation(libs.junit)
}

tasks.named("preBuild") { dependsOn(cargoNdk, shaders) }

publishing.publications.register<MavenPublication>("release") {
    artifactId = "dogleaf"
    afterEvaluate { from(components["release"]) }
}
