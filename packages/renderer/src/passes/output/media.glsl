// Light on its way to the eye: unchanged by the air, until VolumetricFog puts mediaOn in this chunk's place.
// Farol
#define farol_mediaAt(depth) vec4(0.0, 0.0, 0.0, 1.0)
#define farol_throughMedia(radiance, depth) (radiance)
