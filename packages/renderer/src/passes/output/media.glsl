// Effect of fog on light on its way to the eye: none here; VolumetricFog replaces this chunk by mediaOn.
// Farol
#define farol_mediaAt(depth) vec4(0.0, 0.0, 0.0, 1.0)
#define farol_throughMedia(radiance, depth) (radiance)
