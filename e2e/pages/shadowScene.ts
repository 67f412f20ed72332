import * as THREE from 'three';
import type { TestScene } from './materialScene';

/** Which kind of light casts the shadows of a scene. */
export type ShadowCaster = 'spot' | 'point' | 'directional' | 'mixed';

export interface ShadowSceneOptions {
  caster: ShadowCaster;
  /** Settings of each shadow. */
  settings?: { bias?: number; normalBias?: number; radius?: number; intensity?: number; mapSize?: number };
  /** A spot light's image. */
  map?: THREE.Texture;
  /** Whether one material stands for all that are opaque without holes, and glass and shadow material are left out: 3 programs, not 8. */
  few?: boolean;
}

function addCaster(scene: THREE.Scene, caster: Exclude<ShadowCaster, 'mixed'>, i: number): THREE.Light {
  const side = i % 2 ? 1 : -1;
  if (caster === 'directional') {
    const light = new THREE.DirectionalLight(0xffeedd, 2.5);
    light.position.set(3 * side, 6, 3);
    Object.assign(light.shadow.camera, { left: -6, right: 6, top: 6, bottom: -6, near: 1, far: 20 });
    scene.add(light);
    return light;
  }
  if (caster === 'spot') {
    const light = new THREE.SpotLight(0xddeeff, 90, 16, 0.6, 0.4, 2);
    light.position.set(3 * side, 5, 2);
    light.target.position.set(-side, 0, 0);
    scene.add(light, light.target);
    return light;
  }
  const light = new THREE.PointLight(0xffddee, 40, 12, 2);
  light.position.set(1.2 * side, 2.8, 2.6);
  scene.add(light);
  return light;
}

/** Things of every kind over a floor and before a wall, under lights that cast shadows and some that do not. */
export function shadowScene(width: number, height: number, options: ShadowSceneOptions): TestScene {
  const { caster, settings = {}, few = false } = options;
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0x101418);
  const standard = new THREE.MeshStandardMaterial({ color: 0xcccccc, roughness: 0.7 });
  const floor = new THREE.Mesh(new THREE.PlaneGeometry(14, 14), standard);
  floor.rotation.x = -Math.PI / 2;
  const wall = new THREE.Mesh(
    new THREE.PlaneGeometry(14, 8),
    few ? standard : new THREE.MeshLambertMaterial({ color: 0xbbccdd }),
  );
  wall.position.set(0, 4, -4);
  const box = new THREE.Mesh(
    new THREE.BoxGeometry(1, 1.6, 1),
    few ? standard : new THREE.MeshPhongMaterial({ color: 0xee9966 }),
  );
  box.position.set(-1.6, 0.8, 0);
  box.rotation.y = 0.5;
  const ball = new THREE.Mesh(new THREE.SphereGeometry(0.6, 32, 24), standard);
  ball.position.set(1.4, 1, 0.2);
  const holes = new THREE.DataTexture(
    new Uint8Array([255, 255, 255, 255, 255, 255, 255, 0, 255, 255, 255, 0, 255, 255, 255, 255]),
    2,
    2,
  );
  holes.wrapS = holes.wrapT = THREE.RepeatWrapping;
  holes.repeat.set(3, 3);
  holes.needsUpdate = true;
  const fence = new THREE.Mesh(
    new THREE.PlaneGeometry(1.4, 1.4),
    new THREE.MeshStandardMaterial({ map: holes, alphaTest: 0.5, side: THREE.DoubleSide, color: 0x99dd99 }),
  );
  fence.position.set(0, 1, 0.9);
  const rods = new THREE.InstancedMesh(new THREE.CylinderGeometry(0.08, 0.08, 1.4), standard, 5);
  for (let i = 0; i < 5; i++) rods.setMatrixAt(i, new THREE.Matrix4().makeTranslation(i * 0.5 - 1, 0.7, -1.6));
  const unshadowed = new THREE.Mesh(
    new THREE.BoxGeometry(0.8, 0.3, 0.8),
    few ? standard : new THREE.MeshPhysicalMaterial({ color: 0x6699ff, clearcoat: 1 }),
  );
  unshadowed.position.set(2.6, 0.15, 1.4);
  const glass = new THREE.Mesh(
    new THREE.PlaneGeometry(1.2, 1.2),
    new THREE.MeshStandardMaterial({ color: 0xffaa66, transparent: true, opacity: 0.5 }),
  );
  glass.position.set(-0.6, 0.7, 1.8);
  const mat = new THREE.Mesh(
    new THREE.PlaneGeometry(4, 3),
    new THREE.ShadowMaterial({ color: 0x220044, opacity: 0.7 }),
  );
  mat.rotation.x = -Math.PI / 2;
  mat.position.set(-3, 0.02, -0.5);
  for (const mesh of [floor, wall, box, ball, fence, rods, ...(few ? [] : [glass, mat])]) {
    mesh.receiveShadow = true;
    scene.add(mesh);
  }
  scene.add(unshadowed);
  for (const mesh of [box, ball, fence, rods, unshadowed]) mesh.castShadow = true;
  scene.add(new THREE.HemisphereLight(0x8899aa, 0x332211, 0.4));
  const plain = new THREE.PointLight(0x6688ff, 4, 5);
  plain.position.set(-2.5, 1.5, 2);
  scene.add(plain);
  const kinds = caster === 'mixed' ? (['spot', 'point', 'directional', 'spot', 'point'] as const) : [caster, caster];
  const lights = kinds.map((kind, i) => {
    const light = addCaster(scene, kind, i) as THREE.SpotLight;
    light.castShadow = true;
    if (caster === 'mixed') light.intensity *= 0.4;
    const { mapSize = 256, ...rest } = settings;
    light.shadow.mapSize.set(mapSize, mapSize);
    Object.assign(light.shadow, { bias: -0.004, ...rest });
    if (options.map && kind === 'spot') light.map = options.map;
    return light;
  });
  const camera = new THREE.PerspectiveCamera(50, width / height, 0.1, 60);
  camera.position.set(0, 3.4, 7);
  camera.lookAt(0, 1, 0);
  return { scene, camera, lights };
}
