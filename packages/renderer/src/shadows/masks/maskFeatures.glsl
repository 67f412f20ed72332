// Kinds of shadow maps, cookies, profiles and lights that shaders have code for: here all of them; once a scene has
// masks, replaced by the kinds used so far.
// Farol
#define FAROL_SHADOW_MAPS
#define FAROL_SHADOW_CUBES
#define FAROL_SHADOW_CASCADES
#define FAROL_SHADOW_LOOKUPS 7 // ways of sampling shadow maps that the scene uses, as bits: 1 basic, 2 PCF, 4 variance
#define FAROL_LIGHT_COOKIES
#define FAROL_UNSHADOWED_MASKS
#define FAROL_UNBOUNDED_MASKS
#define FAROL_BOUNDED_MASKS
#define FAROL_POINT_MASKS
#define FAROL_LIGHT_PROFILES
#define FAROL_SOFT_SHADOWS
