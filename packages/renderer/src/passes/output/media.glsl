// Light on its way to the eye: without fog, until VolumetricFog replaces this chunk by mediaOn.
// Farol
#define farol_mediaAt(depth) vec4(0.0, 0.0, 0.0, 1.0)
#define farol_throughMedia(radiance, depth) (radiance)
