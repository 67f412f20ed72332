import { type AreaLightShape, setLightOptions } from '@farol/renderer/light-options';
import { IESLoader } from '@farol/renderer/light-profiles';
import { VolumetricFog } from '@farol/renderer/volumetric-fog';
import * as THREE from 'three';
import { compareImages } from '../support/images';
import { Bench, type PageImage } from './Bench';

const WIDTH = 32;
const HEIGHT = 20;
const STEPS = 512;
/** Parts along a side into which an area light is cut. */
const PARTS = 6;
const COLOUR = new THREE.Color(1, 0.7, 0.4);
const RANGE = 8;
/** Point that the lights with a cone shine at (m). */
const TARGET = new THREE.Vector3(-0.6, -0.8, -5);

/** Share of light that is scattered from a direction (unit, to the light) to the eye, per steradian. */
type Scatters = (toLight: THREE.Vector3) => number;
/** Sum over a lamp's parts of what they send to a place times its share that is scattered to the eye. */
type Arriving = (at: THREE.Vector3, scatters: Scatters) => number;

interface LightCase {
  readonly objects: THREE.Object3D[];
  readonly arriving: Arriving;
}

function turned<Light extends THREE.Light>(light: Light): Light {
  light.position.set(0.8, 0.9, -4);
  light.rotation.set(-0.7, 0.4, 0.3);
  light.updateMatrixWorld();
  return light;
}

function area(shape: AreaLightShape): LightCase {
  const [width, height] = shape === 'tube' ? [2, 0.1] : [1.2, 0.8];
  const light = turned(new THREE.RectAreaLight(COLOUR, 4, width, height));
  setLightOptions(light, { shape, range: 0 });
  const normal = new THREE.Vector3(0, 0, -1).transformDirection(light.matrixWorld);
  const axis = new THREE.Vector3(1, 0, 0).transformDirection(light.matrixWorld);
  const [across, up] = shape === 'tube' ? [24, 1] : [PARTS, PARTS];
  const part = (width * height) / (across * up);
  const toLight = new THREE.Vector3();
  return {
    objects: [light],
    arriving(at, scatters) {
      let sum = 0;
      for (let i = 0; i < across * up; i++) {
        const x = (((i % across) + 0.5) / across) * 2 - 1;
        const y = ((Math.floor(i / across) + 0.5) / up) * 2 - 1;
        if (shape === 'disc' && x * x + y * y > 1) continue;
        toLight
          .set((x * width) / 2, (y * height) / 2, 0)
          .applyMatrix4(light.matrixWorld)
          .sub(at);
        const squared = Math.max(toLight.lengthSq(), 1e-3);
        toLight.normalize();
        const faces = shape === 'tube' ? Math.sqrt(1 - toLight.dot(axis) ** 2) : Math.max(0, -toLight.dot(normal));
        sum += ((4 * part * faces) / squared) * scatters(toLight);
      }
      return sum;
    },
  };
}

/** A lamp at a point; `share` is of its light in a direction (unit, away from it), 0 to 1. */
function lampOf(objects: THREE.Object3D[], intensity: number, share: (away: THREE.Vector3) => number): LightCase {
  const { position } = objects[0];
  const away = new THREE.Vector3();
  return {
    objects,
    arriving(at, scatters) {
      away.copy(at).sub(position);
      const distance = away.length();
      away.divideScalar(distance);
      const window = Math.max(0, 1 - (distance / RANGE) ** 4) ** 2;
      const light = (intensity * share(away) * window) / Math.max(distance * distance, 0.01);
      return light * scatters(away.negate());
    },
  };
}

/** A smooth image of 16 × 16 texels of light, 0 to 1, and its value at a place (0 to 1). */
function slide(): { texture: THREE.DataTexture; at(u: number, v: number): number } {
  const at = (u: number, v: number) => 0.6 + 0.4 * Math.sin(u * 7) * Math.cos(v * 5);
  const data = new Float32Array(16 * 16 * 4);
  for (let i = 0; i < 256; i++) data.fill(at(((i % 16) + 0.5) / 16, (Math.floor(i / 16) + 0.5) / 16), i * 4, i * 4 + 4);
  const texture = new THREE.DataTexture(data, 16, 16, THREE.RGBAFormat, THREE.FloatType);
  Object.assign(texture, { minFilter: THREE.LinearFilter, magFilter: THREE.LinearFilter, needsUpdate: true });
  return { texture, at };
}

function spotOf(angle: number, penumbra: number): THREE.SpotLight {
  const spot = turned(new THREE.SpotLight(COLOUR, 30, RANGE, angle, penumbra));
  spot.target.position.copy(TARGET);
  spot.target.updateMatrixWorld();
  return spot;
}

function cone(spot: THREE.SpotLight): (away: THREE.Vector3) => number {
  const axis = TARGET.clone().sub(spot.position).normalize();
  const [outer, inner] = [Math.cos(spot.angle), Math.cos(spot.angle * (1 - spot.penumbra))];
  return (away) => THREE.MathUtils.smoothstep(away.dot(axis), outer, inner);
}

function cookie(): LightCase {
  const spot = spotOf(1.3, 0.5);
  const { texture, at } = slide();
  spot.map = texture;
  spot.shadow.camera.near = 0.01; // nearer, three shines without the map
  spot.shadow.updateMatrices(spot);
  const camera = spot.shadow.camera;
  const toImage = new THREE.Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  const place = new THREE.Vector3();
  const inCone = cone(spot);
  return lampOf([spot, spot.target], 30, (away) => {
    const share = inCone(away);
    if (share === 0) return 0;
    place.copy(spot.position).addScaledVector(away, 2).applyMatrix4(toImage);
    return share * at(place.x / 2 + 0.5, place.y / 2 + 0.5);
  });
}

function profile(): LightCase {
  const candela = [0, 15, 30, 45, 60, 75, 90, 180].map((angle) => Math.round(1000 * Math.cos((angle * Math.PI) / 400)));
  const text = `IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 8 1 1 2 0 0 0 1 1 10\n0 15 30 45 60 75 90 180\n0\n${candela.join(' ')}`;
  const file = new IESLoader().parse(text);
  const spot = spotOf(1.3, 0.5);
  setLightOptions(spot, { profile: file.texture });
  const axis = TARGET.clone().sub(spot.position).normalize();
  const inCone = cone(spot);
  return lampOf([spot, spot.target], 30, (away) => {
    const angle = Math.acos(THREE.MathUtils.clamp(away.dot(axis), -1, 1)) * THREE.MathUtils.RAD2DEG;
    return (inCone(away) * file.intensityAt(angle, 0)) / file.maximumIntensity;
  });
}

const cases = {
  rectangle: () => area('rectangle'),
  disc: () => area('disc'),
  tube: () => area('tube'),
  'spot light': () => {
    const spot = spotOf(1.3, 0.5);
    return lampOf([spot, spot.target], 30, cone(spot));
  },
  'spot light with a map': cookie,
  'spot light with a photometric profile': profile,
};

export type LightCaseName = keyof typeof cases;

/** PSNR (dB) of fog in which one lamp hangs, drawn by clustered-forward, to a march of 512 steps on the CPU; and its peak. */
export function fogByLight(name: LightCaseName): { psnr: number; brightest: number } {
  const { objects, arriving } = cases[name]();
  const bench = new Bench(WIDTH, HEIGHT);
  const scene = new THREE.Scene().add(...objects);
  const camera = new THREE.PerspectiveCamera(60, WIDTH / HEIGHT, 0.1, 50);
  camera.updateMatrixWorld();
  const fog = new VolumetricFog();
  Object.assign(fog, { density: 0.1, anisotropy: 0.3, distance: 12, time: 0, froxels: [WIDTH, HEIGHT, 64] });
  bench.farol.effects = [fog];
  let image!: PageImage;
  for (let frame = 0; frame < 32; frame++) image = bench.byTechnique('clustered-forward', scene, camera);
  const marched = march(camera, fog, arriving);
  bench.free();
  return { psnr: compareImages(marched, image).psnr, brightest: Math.max(...marched.data) };
}

function march(camera: THREE.PerspectiveCamera, fog: VolumetricFog, arriving: Arriving): PageImage {
  const { density, anisotropy: g, distance } = fog;
  const data = new Float32Array(WIDTH * HEIGHT * 4);
  const ray = new THREE.Vector3();
  const at = new THREE.Vector3();
  const scatters: Scatters = (toLight) => (1 - g * g) / (4 * Math.PI * (1 + g * g - 2 * g * toLight.dot(ray)) ** 1.5);
  for (let pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
    const x = (((pixel % WIDTH) + 0.5) / WIDTH) * 2 - 1;
    const y = ((Math.floor(pixel / WIDTH) + 0.5) / HEIGHT) * 2 - 1;
    ray.set(x, y, 0.5).unproject(camera);
    ray.multiplyScalar(distance / -ray.z);
    const step = ray.length() / STEPS;
    ray.normalize();
    let sum = 0;
    for (let i = 0; i < STEPS; i++) {
      const along = (i + 0.5) * step;
      sum += Math.exp(-density * along) * density * arriving(at.copy(ray).multiplyScalar(along), scatters) * step;
    }
    data.set([sum * COLOUR.r, sum * COLOUR.g, sum * COLOUR.b, 1], pixel * 4);
  }
  return { width: WIDTH, height: HEIGHT, data };
}
