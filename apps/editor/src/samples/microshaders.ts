import type { Vector3Tuple } from '@farol/engine/fields';
import { addCamera, mesh } from './parts';
import { SampleScene } from './SampleScene';

/** Replaces the renderer's attenuation: light falls off in rings. */
const lightAttenuation = `// Light that falls off in rings, in place of a smooth slope. Try another number of rings, or softer edges.
// Falloff of three.js; the rings are of this sample
const float RINGS = 6.0;
const float EDGE = 0.12; // of a ring's width

// the distance (m) whose light a whole ring gets; softened at its edge
float farol_ringed(const in float lightDistance, const in float range) {
  if (range <= 0.0) return lightDistance;
  float ring = lightDistance / range * RINGS;
  float edge = smoothstep(1.0 - EDGE, 1.0, fract(ring));
  return (floor(ring) + 0.5 + edge) / RINGS * range;
}

float farol_distanceAttenuation(const in float lightDistance, const in float range, const in float decay) {
  float d = farol_ringed(lightDistance, range);
  float falloff = 1.0 / max(pow(d, decay), 0.01);
  if (range > 0.0) {
    float ratio = d / range;
    ratio *= ratio;
    float window = clamp(1.0 - ratio * ratio, 0.0, 1.0);
    falloff *= window * window;
  }
  return falloff;
}

// the same from squares, as most lights use it
float farol_boundedAttenuation(const in float distanceSquared, const in float ratioSquared, const in float decay) {
  float range = sqrt(distanceSquared / max(ratioSquared, 1e-12));
  return farol_distanceAttenuation(sqrt(distanceSquared), range, decay);
}

float farol_nearFarAttenuation(const in float lightDistance, const in float nearDistance, const in float farDistance) {
  return clamp((farDistance - lightDistance) / max(farDistance - nearDistance, 1e-6), 0.0, 1.0);
}

float farol_polynomialAttenuation(const in float lightDistance, const in vec3 factors, const in float range) {
  if (range > 0.0 && lightDistance > range) return 0.0;
  return 1.0 / max(factors.x + lightDistance * (factors.y + lightDistance * factors.z), 0.01);
}
`;

/** Replaces the renderer's GGX: highlights with a hard edge. */
const ggx = `// Highlights as of a drawing: a flat spot with a hard edge, in place of a smooth lobe.
// Lake, Marshall, Harris and Blackstein 2000, Stylized Rendering Techniques for Scalable Real-Time 3D Animation
float farol_smithLambda(const in float alphaSquared, const in float cosine) {
  return sqrt(alphaSquared + (1.0 - alphaSquared) * cosine * cosine);
}

float farol_ggxLobe(const in float alphaSquared, const in float lambdaV, const in float dotNV, const in float dotNL,
  const in float dotNH) {
  float size = 0.02 + 0.12 * sqrt(alphaSquared);
  return dotNL > 0.0 ? 1.6 * smoothstep(1.0 - size, 1.0 - size * 0.85, dotNH) : 0.0;
}

float farol_blinnPhongLobe(const in float shininess, const in float dotNH) {
  return 0.0795774716 * (shininess * 0.5 + 1.0) * pow(dotNH, shininess);
}

float farol_schlickPower(const in float dotVH) {
  return exp2((-5.55473 * dotVH - 6.98316) * dotVH);
}
`;

const hues: readonly Vector3Tuple[] = [
  [1, 0.25, 0.2],
  [1, 0.75, 0.2],
  [0.35, 1, 0.35],
  [0.2, 0.85, 1],
  [0.4, 0.4, 1],
  [1, 0.35, 0.85],
];

/** Solids on a white floor among 24 moving lights, drawn with two microshaders of the scene. */
export async function microshaders(): Promise<SampleScene> {
  const scene = new SampleScene('Microshaders');
  Object.assign(scene.microShaders, { ggx, lightAttenuation });
  Object.assign(scene.settings, {
    ...{ backgroundColour: [0.012, 0.012, 0.02], toneMapping: 'aces-filmic', exposure: 0.8 },
    ...{ bloom: true, bloomIntensity: 0.35, bloomThreshold: 1.5 },
  });
  addCamera(scene, [0, 5.2, 9.6], [0, 0.5, 0.4], { fov: 0.85 });
  scene.object('Sky', { position: [0, 6, 0] }, [
    'Light',
    { type: 'hemisphere', diffuse: [0.5, 0.55, 0.8], groundColour: [0.2, 0.15, 0.2], intensity: 0.2 },
  ]);
  scene.object('Floor', { scale: [26, 1, 26] }, mesh('plane', { colour: [0.85, 0.85, 0.88], roughness: 0.65 }));
  const solids = scene.object('Solids', {});
  const shapes = ['sphere', 'torus', 'cone', 'cylinder', 'box', 'sphere', 'torus'] as const;
  for (const [i, shape] of shapes.entries()) {
    const angle = (i / shapes.length) * Math.PI * 2;
    const place = {
      position: [Math.sin(angle) * 2.9, shape === 'torus' ? 0.75 : 0.65, Math.cos(angle) * 2.2] as const,
      rotation: [shape === 'torus' ? 0.5 : 0, angle, 0] as const,
      scale: [1.3, 1.3, 1.3] as const,
      parent: solids,
    };
    scene.object(shape, place, mesh(shape, { colour: [0.8, 0.78, 0.75], roughness: 0.35 }));
  }
  scene.object(
    'Dragon',
    { rotation: [0, 0.5, 0], scale: [2.6, 2.6, 2.6], parent: solids },
    mesh('dragon', { colour: [0.78, 0.76, 0.72], roughness: 0.4, creaseAngle: Math.PI }),
  );
  const lights = scene.object('Lights', {});
  for (let i = 0; i < 24; i++) {
    const diffuse = hues[i % hues.length];
    const angle = i * 2.39996;
    const far = 1.2 + 1.05 * Math.sqrt(i);
    scene.object(
      'Light',
      { position: [Math.sin(angle) * far, 0.6 + (i % 3) * 0.45, Math.cos(angle) * far], parent: lights },
      ['Light', { diffuse, intensity: 5, range: 3.6, ...(i < 2 && { castShadow: true, shadowMapSize: 512 }) }],
      ['ObjectRenderer', { mesh: 'bulb', kind: 'basic', colour: diffuse, instanced: true }],
      ['RandomMovement', { seed: 100 + i, extent: [1.2, 0.2, 1.2], speed: 0.7 }],
    );
  }
  return scene;
}
