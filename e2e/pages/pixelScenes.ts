import type { FarolEffect, TechniqueName } from '@farol/renderer';
import { AmbientOcclusion } from '@farol/renderer/ambient-occlusion';
import { LightField } from '@farol/renderer/light-field';
import { setLightOptions } from '@farol/renderer/light-options';
import { LightProbes, ProbeGrid, setBakedSurroundings } from '@farol/renderer/light-probes';
import { explainPixel, type PixelLighting } from '@farol/renderer/pixel-lighting';
import { WeightedBlendedOIT } from '@farol/renderer/transparency';
import * as THREE from 'three';
import { Bench } from './Bench';
import { noiseTexture } from './materialScene';
import { random } from './random';
import { shadowScene } from './shadowScene';

export { explainPixel };

const WIDTH = 96;
const HEIGHT = 64;

interface PixelScene {
  readonly scene: THREE.Scene;
  readonly camera: THREE.Camera;
  readonly effects?: readonly FarolEffect[];
}

function room(materials: readonly THREE.Material[]): PixelScene {
  const scene = new THREE.Scene();
  const floor = new THREE.Mesh(new THREE.PlaneGeometry(14, 14), materials[0]);
  floor.rotation.x = -Math.PI / 2;
  const wall = new THREE.Mesh(new THREE.PlaneGeometry(14, 8), materials[1 % materials.length]);
  wall.position.set(0, 4, -4);
  scene.add(floor, wall);
  for (let i = 0; i < 6; i++) {
    const material = materials[i % materials.length];
    const mesh = new THREE.Mesh(
      i % 2 ? new THREE.SphereGeometry(0.6, 24, 16) : new THREE.BoxGeometry(1, 1, 1),
      material,
    );
    mesh.position.set(i - 2.5, 0.6, (i % 3) - 1.5);
    mesh.rotation.y = i;
    scene.add(mesh);
  }
  const camera = new THREE.PerspectiveCamera(50, WIDTH / HEIGHT, 0.1, 50);
  camera.position.set(0, 2.4, 5.5);
  camera.lookAt(0, 0.8, -1);
  return { scene, camera };
}

/** A lightmap of three texels, with texture coordinates of its own. */
function lightmap(): THREE.DataTexture {
  const texture = new THREE.DataTexture(new Float32Array([0.4, 0.2, 0.1, 1, 0.1, 0.3, 0.5, 1]), 2, 1);
  texture.type = THREE.FloatType;
  texture.needsUpdate = true;
  return texture;
}

function lamps(scene: THREE.Scene, count: number, range: number, intensity = 6): void {
  const next = random(7);
  for (let i = 0; i < count; i++) {
    const colour = new THREE.Color().setHSL(next(), 0.6, 0.6);
    const lamp = new THREE.PointLight(colour, intensity, range);
    lamp.position.set(next() * 8 - 4, 0.3 + next() * 2.5, next() * 6 - 3);
    scene.add(lamp);
  }
}

const standard = (options: THREE.MeshStandardMaterialParameters = {}): THREE.MeshStandardMaterial =>
  new THREE.MeshStandardMaterial({ color: 0xccbbaa, roughness: 0.6, ...options });

/** A floor in the sun, with a board above its middle, and a lamp without a shadow beside it. */
function board(): PixelScene {
  const scene = new THREE.Scene();
  const floor = new THREE.Mesh(new THREE.PlaneGeometry(8, 8), standard());
  floor.rotation.x = -Math.PI / 2;
  const shade = new THREE.Mesh(new THREE.BoxGeometry(1.6, 0.1, 1.6), floor.material);
  shade.position.y = 1.6;
  shade.castShadow = true;
  floor.receiveShadow = true;
  const sun = new THREE.DirectionalLight(0xffeedd, 1);
  sun.position.set(0, 6, 0);
  sun.castShadow = true;
  const lamp = new THREE.PointLight(0x80a0ff, 3, 6);
  lamp.position.set(1.5, 1, 0);
  scene.add(floor, shade, sun, lamp);
  const camera = new THREE.PerspectiveCamera(50, WIDTH / HEIGHT, 0.1, 50);
  camera.position.set(0, 1, 4);
  camera.lookAt(0, 0, 0);
  return { scene, camera };
}

/** Scenes whose pixels are taken apart into the light of each source; each has other kinds of light. */
export const pixelScenes: Readonly<Record<string, (bench: Bench) => PixelScene>> = {
  board,
  effects: () => {
    const made = room([standard(), standard({ transparent: true, opacity: 0.6 }), standard({ color: 0x88aadd })]);
    const { scene } = made;
    scene.add(new THREE.AmbientLight(0xffffff, 0.6));
    lamps(scene, 3, 6);
    const grid = new ProbeGrid(
      { min: [-4, 0, -4], max: [4, 4, 4], counts: [2, 2, 2] },
      new Float32Array(8 * 27).map((_value, i) => (i % 27 < 3 ? 0.3 + (i % 5) * 0.05 : 0)),
    );
    setBakedSurroundings(scene, { grid, hasSky: false });
    return { ...made, effects: [new AmbientOcclusion(), new LightProbes(), new WeightedBlendedOIT()] };
  },
  shadows: () => shadowScene(WIDTH, HEIGHT, { caster: 'mixed' }),
  surroundings: (bench) => {
    const made = room([
      standard({ envMapIntensity: 0.7 }),
      standard({ emissive: 0x203040, emissiveMap: noiseTexture(3, 'colour') }),
      standard({ lightMap: lightmap(), metalness: 0.4 }),
    ]);
    const { scene } = made;
    scene.environment = bench.environment();
    scene.environmentIntensity = 0.8;
    scene.fog = new THREE.FogExp2(0x8090a0, 0.05);
    scene.background = new THREE.Color(0x8090a0);
    scene.add(new THREE.AmbientLight(0x334455, 1), new THREE.HemisphereLight(0x8090ff, 0x402010, 0.6));
    lamps(scene, 3, 6);
    return made;
  },
  field: () => {
    const made = room([standard(), new THREE.MeshLambertMaterial({ color: 0xbbccdd })]);
    const next = random(11);
    const field = new LightField(120, { spots: true });
    for (let i = 0; i < 120; i++) {
      field.setPoint(i, next() * 10 - 5, 0.2 + next() * 2, next() * 8 - 5, 1.6, 0.3 * next(), 0.3 * next(), 0.2);
      if (i % 4 === 0) field.setCone(i, next() - 0.5, -1, next() - 0.5, 0.8, 0.5);
    }
    field.position.y = 0.1;
    field.intensity = 1.2;
    made.scene.add(field);
    lamps(made.scene, 2, 5);
    return made;
  },
  areas: () => {
    const made = room([standard({ roughness: 0.3 }), standard({ metalness: 0.8 })]);
    const panel = new THREE.RectAreaLight(0xffeedd, 6, 2, 1);
    panel.position.set(-2, 3, 1);
    panel.lookAt(0, 0, -1);
    panel.castShadow = true;
    const tube = new THREE.RectAreaLight(0x80a0ff, 20, 2, 0.05);
    tube.position.set(2, 2, -1);
    tube.lookAt(0, 0, 0);
    setLightOptions(tube, { shape: 'tube', range: 8 });
    made.scene.add(panel, tube);
    lamps(made.scene, 2, 5);
    return made;
  },
  cookies: () => {
    const made = room([standard(), new THREE.MeshPhongMaterial({ color: 0xee9966, shininess: 60 })]);
    const spot = new THREE.SpotLight(0xffffff, 120, 14, 0.5, 0.3);
    spot.position.set(2, 5, 3);
    spot.map = noiseTexture(5, 'colour');
    spot.castShadow = true;
    const thesis = new THREE.PointLight(0xff8080, 3, 6);
    thesis.position.set(-2, 1.5, 1);
    setLightOptions(thesis, { ambient: [0.05, 0.1, 0.05], specular: [1, 0, 0] });
    made.scene.add(spot, spot.target, thesis);
    return made;
  },
  glass: (bench) => {
    const glass = new THREE.MeshPhysicalMaterial({
      transmission: 0.9,
      thickness: 0.4,
      roughness: 0.1,
      color: 0xddffee,
    });
    const made = room([standard(), standard({ color: 0x88aadd }), glass]);
    made.scene.environment = bench.environment();
    lamps(made.scene, 4, 7);
    return made;
  },
  orthographic: () => {
    const made = room([standard(), new THREE.MeshToonMaterial({ color: 0x99cc88 })]);
    const camera = new THREE.OrthographicCamera(-4.5, 4.5, 3, -3, 0.1, 30);
    camera.position.set(2, 3, 6);
    camera.lookAt(0, 1, -1);
    const sun = new THREE.DirectionalLight(0xfff0dd, 1.5);
    sun.position.set(3, 6, 4);
    sun.castShadow = true;
    made.scene.add(sun);
    made.scene.fog = new THREE.Fog(0x556677, 4, 20);
    lamps(made.scene, 3, 5);
    return { scene: made.scene, camera };
  },
  many: () => {
    const made = room([standard()]);
    lamps(made.scene, 200, 1, 0.5);
    return made;
  },
  layered: () => {
    const made = room([
      standard(),
      new THREE.MeshPhysicalMaterial({ color: 0x6699ff, clearcoat: 1, sheen: 0.5 }),
      standard({ transparent: true, opacity: 0.5, side: THREE.DoubleSide, color: 0xffaa66 }),
      new THREE.MeshBasicMaterial({ color: 0x406080 }),
      new THREE.MeshLambertMaterial({ color: 0xffffff, emissive: 0x101000, flatShading: true }),
    ]);
    made.scene.background = new THREE.Color(0x203040);
    lamps(made.scene, 5, 6);
    return made;
  },
  probes: () => {
    const made = room([
      standard({ normalMap: noiseTexture(2, 'normal') }),
      new THREE.MeshStandardMaterial({ roughness: 0.9 }),
    ]);
    const probe = new THREE.LightProbe();
    probe.sh.coefficients.forEach((each, i) => each.set(0.3 - i * 0.02, 0.2, 0.1 + i * 0.02));
    const dark = new THREE.PointLight(0xffffff, -1, 4);
    dark.position.set(1, 1, 1);
    const sun = new THREE.DirectionalLight(0xddeeff, 0.8);
    sun.position.set(-3, 5, 2);
    made.scene.add(probe, dark, sun);
    lamps(made.scene, 3, 0);
    return made;
  },
};

export interface PixelCheck {
  readonly scene: string;
  readonly technique: string;
  /** Greatest difference of the shares' sum from the pixel, over its brightness where that is above 1. */
  readonly difference: number;
  readonly at: string;
  /** Shares of the light of lights, by their numbers, of all pixels. */
  readonly lights: number;
  readonly others: readonly string[];
  /** Effects that the parts were drawn without. */
  readonly leftOut: readonly string[];
  /** Programs that were compiled for the second pixel and those after it. */
  readonly programs: number;
}

/** Takes pixels of a scene apart by a technique. */
export async function checkPixels(
  bench: Bench,
  name: string,
  technique: TechniqueName,
  count: number,
): Promise<PixelCheck> {
  const { scene, camera, effects = [] } = pixelScenes[name](bench);
  const { farol, webgl } = bench;
  farol.effects = effects;
  bench.setSize(WIDTH, HEIGHT);
  webgl.shadowMap.enabled = true;
  farol.technique = technique;
  const picture = bench.byTechnique(technique, scene, camera);
  const next = random(name.length * 31 + 5);
  let difference = 0;
  let at = '';
  let lights = 0;
  let programs = 0;
  let leftOut: readonly string[] = [];
  const others = new Set<string>();
  for (let i = 0; i < count; i++) {
    const x = Math.floor(next() * WIDTH);
    const y = Math.floor(next() * HEIGHT);
    const pointer = { x: ((x + 0.5) / WIDTH) * 2 - 1, y: ((y + 0.5) / HEIGHT) * 2 - 1 };
    const made = webgl.info.programs!.length;
    const lighting: PixelLighting = await explainPixel(farol, scene, camera, pointer);
    if (i > 0) programs += webgl.info.programs!.length - made;
    const { sum } = lighting;
    leftOut = lighting.effectsLeftOut;
    const pixel = [...picture.data.subarray((y * WIDTH + x) * 4, (y * WIDTH + x) * 4 + 3)];
    const bright = Math.max(1, ...pixel);
    const off = Math.max(...[sum.r, sum.g, sum.b].map((value, k) => Math.abs(value - pixel[k]))) / bright;
    if (off > difference) {
      difference = off;
      const shares = [...lighting.others, ...lighting.lights].map((each) => [
        'kind' in each ? each.kind : each.light.type,
        ...each.color.toArray(),
      ]);
      at = `${x}, ${y}: ${sum.toArray()} for ${pixel} by ${JSON.stringify(shares)}`;
    }
    lights += lighting.lights.length;
    for (const { kind } of lighting.others) others.add(kind);
  }
  return { scene: name, technique, difference, at, lights, others: [...others], leftOut, programs };
}

/** Takes the pixel under the board apart: what its lights give, and whether the host's objects are as before. */
export async function shadedPixel(bench: Bench): Promise<{
  shaded: { type: string; color: number[]; unshadowed: number[]; share: number; distance: number | null }[];
  kept: boolean;
  changed: boolean;
}> {
  const { scene, camera } = board();
  const { farol, webgl } = bench;
  bench.draw(() => farol.render(scene, camera));
  const state = (): string => JSON.stringify([scene.toJSON(), farol.technique, farol.view, webgl.autoClear]);
  const before = state();
  webgl.setRenderTarget(bench.target);
  // the middle of the floor
  const { lights, changed } = await explainPixel(farol, scene, camera, { x: 0, y: 0 });
  const kept = state() === before && webgl.getRenderTarget() === bench.target;
  webgl.setRenderTarget(null);
  return {
    shaded: lights.map(({ light, color, unshadowed, share, distance }) => ({
      ...{ type: light.type, color: color.toArray(), unshadowed: unshadowed.toArray(), share, distance },
    })),
    kept,
    changed,
  };
}
