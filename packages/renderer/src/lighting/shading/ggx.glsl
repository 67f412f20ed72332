// Specular lobes of one light: visibility times distribution, and Fresnel's weight.
// Walter et al. 2007 (GGX); Heitz 2014, Hammon 2017 (Smith); Blinn 1977; Schlick 1994; three.js r187
//? farol_smithLambda(0.25, 1.0) == 1.0
//? farol_ggxLobe(1.0, 1.0, 1.0, 1.0, 1.0) == 0.07957747
//? farol_ggxLobe(1.0, farol_smithLambda(1.0, 0.5), 0.5, 0.5, 0.8) == 0.15915494
//? farol_blinnPhongLobe(2.0, 0.5) == 0.03978874
//? farol_schlickPower(0.0) == 1.0

// one direction's part of the height-correlated Smith term; cosine: with the normal; alphaSquared: roughness⁴
float farol_smithLambda(const in float alphaSquared, const in float cosine) {
  return sqrt(alphaSquared + (1.0 - alphaSquared) * cosine * cosine);
}

// visibility 0.5 / shadowing, times distribution alpha² / (pi d²); lambdaV: farol_smithLambda of dotNV
float farol_ggxLobe(const in float alphaSquared, const in float lambdaV, const in float dotNV, const in float dotNL,
  const in float dotNH) {
#ifdef FAROL_LITE
  // Hammon's approximation of the Smith term, without a root for each light
  float alpha = sqrt(alphaSquared);
  float shadowing = dotNL * (2.0 * dotNV * (1.0 - alpha) + alpha) + dotNV * alpha;
#else
  float shadowing = dotNL * lambdaV + dotNV * farol_smithLambda(alphaSquared, dotNL);
#endif
  float d = dotNH * dotNH * (alphaSquared - 1.0) + 1.0;
  return 0.1591549431 * alphaSquared / (max(shadowing, 1e-6) * d * d);
}

// visibility 0.25, times distribution (shininess / 2 + 1) / pi (n·h)^shininess
float farol_blinnPhongLobe(const in float shininess, const in float dotNH) {
  return 0.0795774716 * (shininess * 0.5 + 1.0) * pow(dotNH, shininess);
}

// Schlick's fifth power of 1 - cosine
float farol_schlickPower(const in float dotVH) {
  return exp2((-5.55473 * dotVH - 6.98316) * dotVH);
}
