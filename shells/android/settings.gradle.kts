// For Android Studio: the library and the demo. On a plain JVM the same sources build with Maven (pom.xml).
pluginManagement {
    repositories {
        google()
        mavenCentral()
        gradlePluginPortal()
    }
}

dependencyResolutionManagement {
    repositories {
        google()
        mavenCentral()
    }
}

rootProject.name = "dogleaf-android"
include(":dogleaf", ":demo")
