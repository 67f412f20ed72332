import type { FarolRenderer } from '@farol/renderer';
import { setLightOptions } from '@farol/renderer/light-options';
import { LightField } from '@farol/renderer/light-field';
import * as THREE from 'three';
import { textureOf } from './buildMaterial';
import type { LightFacts, ShadowFacts } from './SceneFacts';

type Shadowed = THREE.DirectionalLight | THREE.PointLight | THREE.SpotLight;

function addShadow(light: Shadowed, facts: ShadowFacts): void {
  // without a bias a surface shadows itself where its depths happen to be rounded up
  const { mapSize, near, far, bias = -0.005, ...rest } = facts;
  light.castShadow = true;
  if (mapSize !== undefined) light.shadow.mapSize.set(mapSize, mapSize);
  Object.assign(light.shadow, { bias, ...rest });
  if (near !== undefined) light.shadow.camera.near = near;
  if (far !== undefined) light.shadow.camera.far = far;
}

/** A profile of two beams, by vertical angle. */
let madeProfile: THREE.DataTexture | null = null;
function profile(): THREE.DataTexture {
  if (madeProfile) return madeProfile;
  const values = Float32Array.from({ length: 64 }, (_, i) => 0.2 + 0.8 * Math.abs(Math.cos(i / 9)));
  madeProfile = new THREE.DataTexture(values, 64, 1, THREE.RedFormat, THREE.FloatType);
  madeProfile.needsUpdate = true;
  return madeProfile;
}

/** Places of the lights of a `count`: round the first. */
function spread(position: THREE.Vector3, i: number): THREE.Vector3 {
  if (i === 0) return position;
  const angle = i * 2.4;
  return position.add(
    new THREE.Vector3(Math.cos(angle), Math.sin(i) * 0.3, Math.sin(angle)).multiplyScalar(0.4 * i ** 0.6),
  );
}

function lightOf(facts: LightFacts): THREE.Light {
  const { kind = 'point', color = 0xffffff, intensity = 2, distance = 0, decay = 2 } = facts;
  switch (kind) {
    case 'ambient':
      return new THREE.AmbientLight(color, intensity);
    case 'hemisphere':
      return new THREE.HemisphereLight(color, facts.ground ?? 0, intensity);
    case 'directional':
      return new THREE.DirectionalLight(color, intensity);
    case 'probe': {
      const probe = new THREE.LightProbe(undefined, intensity);
      probe.sh.coefficients.forEach((value, i) => value.set(0.5 / (i + 1), 0.3, 0.2 + 0.05 * i));
      return probe;
    }
    case 'area': {
      const light = new THREE.RectAreaLight(color, intensity, facts.width ?? 1, facts.height ?? 1);
      if (facts.shape) setLightOptions(light, { shape: facts.shape });
      if (facts.castShadow) light.castShadow = true;
      return light;
    }
    case 'spot':
      return new THREE.SpotLight(color, intensity, distance, facts.angle ?? 0.8, facts.penumbra ?? 0.3, decay);
    case 'field':
      return facts.angle === undefined
        ? new THREE.PointLight(color, intensity, distance || 5, decay)
        : new THREE.SpotLight(color, intensity, distance || 5, facts.angle, facts.penumbra ?? 0.3, decay);
    default:
      return new THREE.PointLight(color, intensity, distance, decay);
  }
}

function buildLight(facts: LightFacts, i: number, scene: THREE.Scene): THREE.Light {
  const light = lightOf(facts);
  if (facts.position) light.position.copy(spread(new THREE.Vector3(...facts.position), i));
  const target = new THREE.Vector3(...(facts.target ?? [0, 0, 0]));
  if (light instanceof THREE.SpotLight || light instanceof THREE.DirectionalLight) {
    light.target.position.copy(spread(target, i));
    scene.add(light.target);
  }
  if (light instanceof THREE.RectAreaLight) light.lookAt(target);
  if (facts.layer !== undefined) light.layers.set(facts.layer);
  const canCast =
    light instanceof THREE.SpotLight || light instanceof THREE.DirectionalLight || light instanceof THREE.PointLight;
  if (canCast && facts.shadow) addShadow(light, facts.shadow);
  if (facts.map && light instanceof THREE.SpotLight) light.map = textureOf(facts.map);
  if (facts.profile) setLightOptions(light, { profile: profile() });
  if (facts.cookie && light instanceof THREE.PointLight)
    setLightOptions(light, { cookie: textureOf('cube') as THREE.CubeTexture });
  scene.add(light);
  return light;
}

function addToField(field: LightField, i: number, light: THREE.PointLight | THREE.SpotLight): void {
  const { position, color, intensity, distance, decay } = light;
  const [r, g, b] = color.toArray().map((value) => value * intensity);
  field.setPoint(i, position.x, position.y, position.z, distance, r, g, b, decay);
  if (!(light instanceof THREE.SpotLight)) return;
  const { x, y, z } = light.target.position.clone().sub(position);
  field.setCone(i, x, y, z, light.angle, light.penumbra);
}

/** Lights of a scene, with what changes between stock three and Farol: single lights in place of fields. */
export interface BuiltLights {
  /** Shows fields to Farol, and the single lights in place of them to stock three. */
  show(farol: FarolRenderer | null): void;
  dispose(): void;
}

/** Adds the lights that facts describe. */
export function buildLights(facts: readonly LightFacts[], scene: THREE.Scene): BuiltLights {
  const singles: THREE.Light[] = [];
  const fields: LightField[] = [];
  const all: THREE.Light[] = [];
  for (const one of facts) {
    const lights = Array.from({ length: one.count ?? 1 }, (_, i) => buildLight(one, i, scene));
    all.push(...lights);
    if (one.kind !== 'field') continue;
    const field = new LightField(lights.length, { spots: one.angle !== undefined });
    lights.forEach((light, i) => addToField(field, i, light as THREE.SpotLight));
    if (one.layer !== undefined) field.layers.set(one.layer);
    singles.push(...lights);
    fields.push(field);
    scene.add(field);
  }
  return {
    show(farol) {
      for (const light of singles) light.visible = farol === null;
      for (const field of fields) field.visible = farol !== null;
    },
    dispose() {
      for (const light of all) light.dispose();
      for (const field of fields) field.dispose();
    },
  };
}
