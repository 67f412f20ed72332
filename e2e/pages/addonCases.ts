import * as THREE from 'three';
import { AnaglyphEffect } from 'three/addons/effects/AnaglyphEffect.js';
import { OutlineEffect } from 'three/addons/effects/OutlineEffect.js';
import { ParallaxBarrierEffect } from 'three/addons/effects/ParallaxBarrierEffect.js';
import { StereoEffect } from 'three/addons/effects/StereoEffect.js';
import { GroundedSkybox } from 'three/addons/objects/GroundedSkybox.js';
import { Lensflare, LensflareElement } from 'three/addons/objects/Lensflare.js';
import { MarchingCubes } from 'three/addons/objects/MarchingCubes.js';
import { Reflector } from 'three/addons/objects/Reflector.js';
import { Refractor } from 'three/addons/objects/Refractor.js';
import { ShadowMesh } from 'three/addons/objects/ShadowMesh.js';
import { Sky } from 'three/addons/objects/Sky.js';
import { Water } from 'three/addons/objects/Water.js';
import { Water as Water2 } from 'three/addons/objects/Water2.js';
import { colourMap, equirect, normalMap } from './matrix/textures';

export type Render = (scene: THREE.Object3D, camera: THREE.Camera) => void;

/** Puts something of three's addons into a scene; may return a function that draws in place of `render`. */
type AddonCase = (
  scene: THREE.Scene,
  camera: THREE.PerspectiveCamera,
  box: THREE.Mesh,
) => void | ((renderer: THREE.WebGLRenderer) => Render);

const plane = (size = 3) => new THREE.PlaneGeometry(size, size);
const flat = <T extends THREE.Object3D>(object: T): T => {
  object.rotation.x = -Math.PI / 2;
  object.position.y = -0.68;
  return object;
};
/** An effect of three's that draws by a renderer. */
const by =
  (
    Effect: new (renderer: THREE.WebGLRenderer) => {
      render(scene: THREE.Scene, camera: THREE.PerspectiveCamera): void;
      setSize?(width: number, height: number): void;
    },
  ) =>
  (renderer: THREE.WebGLRenderer): Render => {
    const effect = new Effect(renderer);
    return (scene, camera) => effect.render(scene as THREE.Scene, camera as THREE.PerspectiveCamera);
  };

/** three's addons, each in a scene of its own. */
export const addonCases: Record<string, AddonCase> = {
  Reflector: (scene) => void scene.add(flat(new Reflector(plane(), { textureWidth: 64, textureHeight: 48 }))),
  'Reflector that stands': (scene) => {
    const mirror = new Reflector(plane(2), { textureWidth: 64, textureHeight: 48, multisample: 0 });
    mirror.position.set(-0.6, 0.3, -1);
    mirror.rotation.y = 0.3;
    scene.add(mirror);
  },
  Refractor: (scene) => {
    const pane = new Refractor(plane(1.2), { textureWidth: 64, textureHeight: 48, color: 0xccddff });
    pane.position.set(0, 0.2, 1);
    scene.add(pane);
  },
  Water: (scene) =>
    void scene.add(
      flat(
        new Water(plane(), {
          textureWidth: 64,
          textureHeight: 48,
          waterNormals: normalMap(),
          sunDirection: new THREE.Vector3(1, 1, 0),
        }),
      ),
    ),
  Water2: (scene) =>
    void scene.add(
      flat(
        new Water2(plane(), {
          textureWidth: 64,
          textureHeight: 48,
          normalMap0: normalMap(),
          normalMap1: normalMap(),
          flowDirection: new THREE.Vector2(0, 0),
        }),
      ),
    ),
  Lensflare: (scene) => {
    const flare = new Lensflare();
    flare.addElement(new LensflareElement(colourMap(), 24, 0));
    flare.addElement(new LensflareElement(colourMap(), 12, 0.6));
    flare.position.set(-0.8, 0.8, -0.5);
    scene.add(flare);
  },
  ShadowMesh: (scene, _camera, box) => {
    const shadow = new ShadowMesh(box);
    scene.add(shadow);
    scene.updateMatrixWorld();
    shadow.update(new THREE.Plane(new THREE.Vector3(0, 1, 0), 0.65), new THREE.Vector4(2, 4, 3, 0.001));
  },
  Sky: (scene) => {
    const sky = new Sky();
    sky.scale.setScalar(20);
    sky.material.uniforms.sunPosition.value.set(0.3, 0.4, -1);
    scene.add(sky);
  },
  GroundedSkybox: (scene) => {
    const box = new GroundedSkybox(equirect(), 2, 15);
    box.position.y = 1.3;
    scene.add(box);
  },
  MarchingCubes: (scene) => {
    const cubes = new MarchingCubes(16, new THREE.MeshStandardMaterial({ color: 0xffcc44 }), true, true, 5000);
    cubes.addBall(0.5, 0.5, 0.5, 0.6, 12);
    cubes.addBall(0.3, 0.6, 0.5, 0.4, 12);
    cubes.update();
    cubes.position.set(-0.6, 0.2, 0.3);
    scene.add(cubes);
  },
  AnaglyphEffect: () => by(AnaglyphEffect as never),
  StereoEffect: () => by(StereoEffect),
  OutlineEffect: () => by(OutlineEffect as never),
  ParallaxBarrierEffect: () => by(ParallaxBarrierEffect),
};

/** The scene that a case is put into: lit things on a floor, one of them transparent. */
export function addonScene(name: string, width: number, height: number) {
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0x203040);
  const camera = new THREE.PerspectiveCamera(45, width / height, 0.1, 40);
  camera.position.set(0.3, 0.8, 3.6);
  camera.lookAt(0, 0, 0);
  const mesh = (geometry: THREE.BufferGeometry, material: THREE.Material, x: number, y: number, z: number) => {
    const made = new THREE.Mesh(geometry, material);
    made.position.set(x, y, z);
    scene.add(made);
    return made;
  };
  const { MeshStandardMaterial: Standard } = THREE;
  flat(mesh(plane(8), new Standard({ color: 0x888888 }), 0, 0, 0)).position.y = -0.7;
  const box = mesh(
    new THREE.BoxGeometry(0.6, 0.6, 0.6),
    new THREE.MeshPhongMaterial({ color: 0x88ff88 }),
    0.8,
    -0.2,
    0,
  );
  mesh(new THREE.SphereGeometry(0.5, 24, 16), new Standard({ color: 0xffaa88, roughness: 0.4 }), -0.5, -0.1, -0.2);
  mesh(plane(0.8), new Standard({ color: 0x88aaff, transparent: true, opacity: 0.5 }), 0.3, 0, 0.8);
  const lamp = new THREE.PointLight(0xff8844, 10, 9);
  lamp.position.set(1.5, 1, 2);
  const sun = new THREE.DirectionalLight(0xffffff, 1);
  sun.position.set(-1, 2, 2);
  scene.add(new THREE.Group().add(lamp), sun, new THREE.AmbientLight(0xffffff, 0.2));
  const make = addonCases[name](scene, camera, box);
  return { scene, camera, make };
}
