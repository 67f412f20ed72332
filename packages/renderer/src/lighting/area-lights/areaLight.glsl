// Light of rectangles, discs and tubes: none until a scene has such a light.
// Farol; areaLightOn then replaces this chunk
#define FAROL_SET_AREA
#define FAROL_PLAIN_LIGHTS (farol_lightCounts.z - farol_lightCounts.w)
#define FAROL_OTHER_LIGHTS farol_lightCounts.w
#define FAROL_SKIP_AREA(details)
#define FAROL_AREA_SUM
#define FAROL_BEGIN_AREA_SUM
#define FAROL_AREA_SHADING
#define FAROL_ADD_AREA(light)
#define FAROL_ADD_BOUNDED_AREA(s, record)
#define FAROL_AREA_SPECULAR(s, f0, f90, roughness)
#define FAROL_BEGIN_AREAS
#define FAROL_SHADE_AREA(light)
