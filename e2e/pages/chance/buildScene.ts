import type { FarolRenderer } from '@farol/renderer';
import { AmbientOcclusion } from '@farol/renderer/ambient-occlusion';
import { MultisampledEdges, SMAA } from '@farol/renderer/antialiasing';
import { WeightedBlendedOIT } from '@farol/renderer/transparency';
import * as THREE from 'three';
import { RectAreaLightUniformsLib } from 'three/addons/lights/RectAreaLightUniformsLib.js';
import type { Bench } from '../Bench';
import { buildLights } from './buildLights';
import { buildMaterial, textureOf } from './buildMaterial';
import { buildThing, place } from './buildThing';
import type { Kind, MaterialFacts, SceneFacts, ViewFacts, WorldFacts } from './SceneFacts';

const effects = { SMAA, AmbientOcclusion, MultisampledEdges, WeightedBlendedOIT };
const toneMappings = {
  Linear: THREE.LinearToneMapping,
  Reinhard: THREE.ReinhardToneMapping,
  Cineon: THREE.CineonToneMapping,
  ACESFilmic: THREE.ACESFilmicToneMapping,
  AgX: THREE.AgXToneMapping,
  Neutral: THREE.NeutralToneMapping,
};
const shadowTypes = { basic: THREE.BasicShadowMap, vsm: THREE.VSMShadowMap };

/** Materials by their facts: scenes that have one in common share its programs. */
export class Materials {
  private readonly made = new Map<string, THREE.Material>();

  /** @param use - tells apart materials of equal facts that are not to be one */
  of(facts: MaterialFacts = {}, kind: Kind = 'mesh', use = ''): THREE.Material {
    const key = JSON.stringify([facts, kind, use]);
    let material = this.made.get(key);
    if (material === undefined) this.made.set(key, (material = buildMaterial(facts, kind)));
    return material;
  }

  dispose(): void {
    for (const material of this.made.values()) material.dispose();
    this.made.clear();
  }
}

function addWorld(scene: THREE.Scene, world: WorldFacts, bench: Bench, materials: Materials): void {
  const { background, fog, environment, override } = world;
  scene.background =
    typeof background === 'string'
      ? textureOf(background)
      : typeof background === 'number'
        ? new THREE.Color(background)
        : null;
  if (typeof background === 'string') {
    scene.backgroundBlurriness = world.backgroundBlurriness ?? 0;
    if (world.backgroundRotation) scene.backgroundRotation.fromArray([...world.backgroundRotation]);
  }
  scene.backgroundIntensity = world.backgroundIntensity ?? 1;
  if (environment) scene.environment = environment === 'room' ? bench.environment() : textureOf(environment);
  scene.environmentIntensity = world.environmentIntensity ?? 1;
  if (world.environmentRotation) scene.environmentRotation.fromArray([...world.environmentRotation]);
  if (fog?.density !== undefined) scene.fog = new THREE.FogExp2(fog.color ?? 0, fog.density);
  else if (fog) scene.fog = new THREE.Fog(fog.color ?? 0, fog.near ?? 4, fog.far ?? 12);
  if (override) scene.overrideMaterial = materials.of(override);
}

function cameraOf(view: ViewFacts, width: number, height: number): THREE.PerspectiveCamera | THREE.OrthographicCamera {
  const { near = 0.1, far = 60 } = view;
  const camera =
    view.camera === 'orthographic'
      ? new THREE.OrthographicCamera(-4, 4, (4 * height) / width, (-4 * height) / width, near, far)
      : new THREE.PerspectiveCamera(view.fov ?? 50, width / height, near, far);
  camera.position.fromArray(view.position ?? [0, 1, 7]);
  camera.lookAt(...(view.lookAt ?? ([0, 0, 0] as const)));
  camera.zoom = view.zoom ?? 1;
  if (view.offset) camera.setViewOffset(width, height, ...view.offset, width, height);
  for (const layer of view.layers ?? []) camera.layers.enable(layer);
  camera.updateProjectionMatrix();
  return camera;
}

/** Added to edges and sizes of viewports (pixels): WebGL cuts it off. */
const FRACTION = 0.7;

type PartCamera = THREE.PerspectiveCamera & { viewport: THREE.Vector4 };

function arrayOf(camera: THREE.Camera, width: number, height: number): THREE.ArrayCamera {
  const cameras = [0, 1, 2].map((i) => {
    const one = camera.clone() as PartCamera;
    one.position.x += i - 1;
    const left = Math.round((i * width) / 3);
    const right = Math.round(((i + 1) * width) / 3);
    one.viewport = new THREE.Vector4(left + FRACTION, 0, right - left + FRACTION, height);
    one.updateMatrixWorld();
    return one;
  });
  const array = new THREE.ArrayCamera(cameras);
  array.copy(camera as THREE.ArrayCamera, false);
  array.cameras = cameras;
  return array;
}

/** Draws halves of a target or canvas by two cameras. */
function drawTwo(webgl: THREE.WebGLRenderer, camera: THREE.Camera, draw: (camera: THREE.Camera) => void): void {
  const target = webgl.getRenderTarget();
  const { width, height } = target ?? webgl.domElement;
  for (const i of [0, 1]) {
    const part = [(i * width) / 2, 4, width / 2, height - 4] as const;
    if (target) {
      target.viewport.set(...part).addScalar(FRACTION);
      target.scissor.set(...part).addScalar(FRACTION);
      target.scissorTest = true;
      webgl.setRenderTarget(target);
    } else {
      webgl.setViewport(...part);
      webgl.setScissor(...part);
      webgl.setScissorTest(true);
    }
    const one = camera.clone();
    one.position.x -= i;
    draw(one);
  }
  webgl.setViewport(0, 0, width, height);
  webgl.setScissorTest(false);
}

/** A scene that can be drawn by stock three and by Farol. */
export interface BuiltScene {
  /** Draws to the render target or canvas that is set. @param farol - null: by stock three */
  draw(webgl: THREE.WebGLRenderer, farol: FarolRenderer | null): void;
  /** Frees all but the materials. */
  dispose(): void;
}

/** Makes the scene that facts describe, for pictures of the bench's size. */
export function buildScene(facts: SceneFacts, bench: Bench, materials: Materials): BuiltScene {
  const { world = {}, view = {}, things = [], lights = [] } = facts;
  const { width, height } = bench;
  const scene = new THREE.Scene();
  addWorld(scene, world, bench, materials);
  for (const thing of things) scene.add(buildThing(thing, materials.of(thing.material, thing.as, thing.callback)));
  if (lights.some(({ kind }) => kind === 'area')) RectAreaLightUniformsLib.init();
  const built = buildLights(lights, scene);
  const single = cameraOf(view, width, height);
  if (view.parent) scene.add(place(new THREE.Group(), view.parent).add(single));
  scene.updateMatrixWorld();
  const camera = view.camera === 'array' ? arrayOf(single, width, height) : single;
  const active = (world.effects ?? []).map((name) => new effects[name as keyof typeof effects]());
  const planes = (world.clippingPlanes ?? []).map(
    ([x, y, z, constant]) => new THREE.Plane(new THREE.Vector3(x, y, z + 1e-3).normalize(), constant),
  );
  return {
    draw(webgl, farol) {
      webgl.setClearColor(world.clearColor ?? 0, world.clearAlpha ?? 1);
      webgl.clippingPlanes = planes;
      webgl.sortObjects = world.sortObjects ?? true;
      webgl.shadowMap.type = world.shadows ? shadowTypes[world.shadows] : THREE.PCFShadowMap;
      webgl.toneMapping = view.toneMapping ? toneMappings[view.toneMapping] : THREE.NoToneMapping;
      webgl.toneMappingExposure = view.exposure ?? 1;
      webgl.outputColorSpace = view.linearOutput ? THREE.LinearSRGBColorSpace : THREE.SRGBColorSpace;
      built.show(farol);
      if (farol) {
        farol.effects = active;
        farol.shadowCascades = world.shadowCascades ?? 1;
        farol.lightLayers = world.lightLayers ?? false;
      }
      const draw = (seen: THREE.Camera) => (farol ?? webgl).render(scene, seen);
      if (view.camera === 'two') drawTwo(webgl, camera, draw);
      else draw(camera);
    },
    dispose() {
      bench.farol.effects = [];
      for (const effect of active) effect.dispose();
      built.dispose();
      scene.traverse((object) => {
        const mesh = object as THREE.InstancedMesh & THREE.SkinnedMesh & THREE.BatchedMesh;
        if (mesh.isInstancedMesh || mesh.isBatchedMesh) mesh.dispose();
        if (mesh.isSkinnedMesh) mesh.skeleton.dispose();
        mesh.geometry?.dispose();
      });
    },
  };
}
