import * as THREE from 'three';
import { RectAreaLightUniformsLib } from 'three/addons/lights/RectAreaLightUniformsLib.js';
import { random } from './random';
import { isSlice } from './techniquesInTurn';

/** A scene with its camera, ready to draw. */
export interface TestScene {
  scene: THREE.Scene;
  camera: THREE.Camera;
  lights: THREE.Light[];
}

export function noiseTexture(seed: number, kind: 'colour' | 'normal'): THREE.DataTexture {
  const next = random(seed);
  const size = 32;
  const data = new Uint8Array(size * size * 4);
  for (let i = 0; i < data.length; i += 4) {
    if (kind === 'normal') data.set([128 + (next() - 0.5) * 120, 128 + (next() - 0.5) * 120, 235, 255], i);
    else data.set([80 + next() * 175, 80 + next() * 175, 80 + next() * 175, next() > 0.3 ? 255 : 0], i);
  }
  const texture = new THREE.DataTexture(data, size, size);
  texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
  texture.magFilter = texture.minFilter = THREE.LinearFilter;
  if (kind === 'colour') texture.colorSpace = THREE.SRGBColorSpace;
  texture.needsUpdate = true;
  return texture;
}

export function skinned(material: THREE.Material): THREE.SkinnedMesh {
  const geometry = new THREE.CylinderGeometry(0.4, 0.4, 1.6, 16, 8);
  const { position } = geometry.attributes;
  const indices = new Uint16Array(position.count * 4);
  const weights = new Float32Array(position.count * 4);
  for (let i = 0; i < position.count; i++) {
    const t = (position.getY(i) + 0.8) / 1.6;
    indices[i * 4 + 1] = 1;
    weights[i * 4] = 1 - t;
    weights[i * 4 + 1] = t;
  }
  geometry.setAttribute('skinIndex', new THREE.Uint16BufferAttribute(indices, 4));
  geometry.setAttribute('skinWeight', new THREE.Float32BufferAttribute(weights, 4));
  const root = new THREE.Bone();
  const tip = new THREE.Bone();
  root.position.y = -0.8;
  tip.position.y = 0.8;
  root.add(tip);
  const mesh = new THREE.SkinnedMesh(geometry, material);
  mesh.add(root);
  mesh.bind(new THREE.Skeleton([root, tip]));
  tip.rotation.z = 0.8;
  return mesh;
}

export function instanced(material: THREE.Material): THREE.InstancedMesh {
  const mesh = new THREE.InstancedMesh(new THREE.IcosahedronGeometry(0.3, 1), material, 6);
  const matrix = new THREE.Matrix4();
  for (let i = 0; i < 6; i++) {
    mesh.setMatrixAt(i, matrix.makeTranslation(Math.cos(i) * 0.5, Math.sin(i) * 0.5, i * 0.1));
    mesh.setColorAt(i, new THREE.Color().setHSL(i / 6, 1, 0.5));
  }
  return mesh;
}

export function morphed(material: THREE.Material): THREE.Mesh {
  const geometry = new THREE.BoxGeometry(1, 1, 1, 6, 6, 6);
  const { position } = geometry.attributes;
  const target = new Float32Array(position.count * 3);
  const colours = new Float32Array(position.count * 3);
  for (let i = 0; i < position.count; i++) {
    new THREE.Vector3()
      .fromBufferAttribute(position, i)
      .normalize()
      .multiplyScalar(0.8)
      .toArray(target, i * 3);
    for (let c = 0; c < 3; c++) colours[i * 3 + c] = (((i * 3 + c) * 37) % 100) / 100;
  }
  geometry.morphAttributes.position = [new THREE.Float32BufferAttribute(target, 3)];
  geometry.setAttribute('color', new THREE.Float32BufferAttribute(colours, 3));
  const mesh = new THREE.Mesh(geometry, material);
  mesh.morphTargetInfluences = [0.7];
  return mesh;
}

export function batched(material: THREE.Material): THREE.BatchedMesh {
  const mesh = new THREE.BatchedMesh(4, 2000, 6000, material);
  const sphere = mesh.addGeometry(new THREE.SphereGeometry(0.3, 12, 8));
  const box = mesh.addGeometry(new THREE.BoxGeometry(0.4, 0.4, 0.4));
  for (let i = 0; i < 4; i++) {
    const id = mesh.addInstance(i % 2 ? sphere : box);
    mesh.setMatrixAt(id, new THREE.Matrix4().makeTranslation((i % 2) * 0.7 - 0.35, (i >> 1) * 0.7 - 0.35, 0));
    mesh.setColorAt(id, new THREE.Color().setHSL(i / 4, 0.8, 0.5));
  }
  return mesh;
}

/** Which lights a scene has. */
export type LightMix = 'mixed' | 'point' | 'spot' | 'directional' | 'hemisphere' | 'unbounded' | 'area';

function addLights(scene: THREE.Scene, mix: LightMix, count: number, penumbra?: number): THREE.Light[] {
  const next = random(42);
  const lights: THREE.Light[] = [];
  for (let i = 0; i < count; i++) {
    const colour = new THREE.Color().setHSL(next(), 0.8, 0.6);
    const place = new THREE.Vector3((next() * 2 - 1) * 6, (next() * 2 - 1) * 3, 1 + next() * 3);
    const power = 6 + next() * 10;
    const kinds = ['point', 'point', 'spot', 'point', 'spot', 'directional', 'unbounded', 'hemisphere'] as const;
    const kind = mix === 'mixed' ? kinds[i % kinds.length] : mix;
    let light: THREE.Light;
    if (kind === 'point') light = new THREE.PointLight(colour, power, 4, 2);
    else if (kind === 'unbounded') light = new THREE.PointLight(colour, power * 0.1, 0, i % 2 ? 2 : 1.4);
    else if (kind === 'spot') {
      const spot = new THREE.SpotLight(
        colour,
        power * 3,
        i % 3 ? 7 : 0,
        i % 5 ? 0.5 : 1.3,
        penumbra ?? (i % 4) / 5 + 0.1,
        2,
      );
      spot.target.position.set(place.x + next() - 0.5, place.y - next(), -1);
      scene.add(spot.target);
      light = spot;
    } else if (kind === 'area') {
      light = new THREE.RectAreaLight(colour, power * 0.3, 0.2 + next(), 0.2 + next() * 2);
      light.rotation.set(next() * 2 - 1, next() * 2 - 1, next() * 6);
    } else if (kind === 'directional') light = new THREE.DirectionalLight(colour, 0.2);
    else light = new THREE.HemisphereLight(colour, new THREE.Color().setHSL(next(), 0.6, 0.3), 0.1);
    light.position.copy(place);
    lights.push(light);
    if (i % 7 === 3) {
      const group = new THREE.Group();
      group.position.set(0.2, 0.1, 0);
      group.add(light);
      scene.add(group);
    } else scene.add(light);
  }
  return lights;
}

export interface MaterialSceneOptions {
  mix?: LightMix;
  count?: number;
  environment?: THREE.Texture | null;
  orthographic?: boolean;
  /** Leaves out what no G-buffer holds, so that what is compared is the deferred path alone. */
  onlyDeferred?: boolean;
  fog?: boolean;
  /** Which mesh of each so many in a row is shown; default all. */
  part?: readonly [which: number, every: number];
  /** Penumbra of every spot light; default: mixed, none hard-edged. */
  penumbra?: number;
}

/** Part of the meshes for tests whose subject is no material: in the slice a quarter of them, for fewer programs. */
export const fewMeshes = isSlice ? ([0, 4] as const) : undefined;

/**
 * Every lit material of three and every kind of mesh, before a floor, under a seeded mix of lights.
 */
export function materialScene(width: number, height: number, options: MaterialSceneOptions = {}): TestScene {
  const { mix = 'mixed', count = 24 } = options;
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0x203040);
  scene.environment = options.environment ?? null;
  scene.environmentIntensity = 0.3;
  if (options.fog) scene.fog = new THREE.Fog(0x556677, 8, 20);
  const map = noiseTexture(7, 'colour');
  const normalMap = noiseTexture(9, 'normal');
  const sphere = new THREE.SphereGeometry(0.8, 32, 24);
  const meshes: THREE.Mesh[] = [
    new THREE.Mesh(sphere, new THREE.MeshStandardMaterial({ map, normalMap, roughness: 0.5, metalness: 0.2 })),
    new THREE.Mesh(sphere, new THREE.MeshStandardMaterial({ color: 0xffcc66, roughness: 0.25, metalness: 1 })),
    new THREE.Mesh(sphere, new THREE.MeshLambertMaterial({ color: 0x66ff88, map })),
    new THREE.Mesh(
      sphere,
      new THREE.MeshPhongMaterial({ color: 0x6688ff, specular: 0x888888, shininess: 60, normalMap }),
    ),
    new THREE.Mesh(sphere, new THREE.MeshPhysicalMaterial({ color: 0x99bbaa, roughness: 0.35, ior: 1.8 })),
    new THREE.Mesh(
      new THREE.BoxGeometry(1.2, 1.2, 1.2),
      new THREE.MeshStandardMaterial({ map, alphaTest: 0.5, side: THREE.DoubleSide, roughness: 0.8 }),
    ),
    instanced(new THREE.MeshStandardMaterial({ roughness: 0.4, flatShading: true })),
    skinned(new THREE.MeshStandardMaterial({ color: 0xdddddd, roughness: 0.35, emissive: 0x221100 })),
    morphed(new THREE.MeshStandardMaterial({ vertexColors: true, roughness: 0.5 })),
    batched(new THREE.MeshStandardMaterial({ roughness: 0.45 })),
    skinned(new THREE.MeshPhongMaterial({ color: 0xccaa88, shininess: 20 })),
    instanced(new THREE.MeshLambertMaterial({ color: 0xeeeeee })),
  ];
  if (!options.onlyDeferred) {
    meshes.push(
      new THREE.Mesh(
        sphere,
        new THREE.MeshPhysicalMaterial({
          color: 0x884422,
          roughness: 0.6,
          clearcoat: 1,
          clearcoatRoughness: 0.1,
          sheen: 1,
          sheenColor: new THREE.Color(0.3, 0.2, 0.6),
        }),
      ),
      new THREE.Mesh(
        sphere,
        new THREE.MeshPhysicalMaterial({
          color: 0xaaaaaa,
          metalness: 0.9,
          roughness: 0.3,
          anisotropy: 0.7,
          iridescence: 1,
        }),
      ),
      new THREE.Mesh(sphere, new THREE.MeshToonMaterial({ color: 0xff66aa })),
      new THREE.Mesh(sphere, new THREE.MeshBasicMaterial({ map, color: 0xffeecc })),
      new THREE.Mesh(
        sphere,
        new THREE.MeshStandardMaterial({ color: 0x88ccff, transparent: true, opacity: 0.5, side: THREE.DoubleSide }),
      ),
      new THREE.Mesh(sphere, new THREE.MeshPhongMaterial({ color: 0xffffff, transparent: true, opacity: 0.6 })),
    );
  }
  const [which, every] = options.part ?? [0, 1];
  meshes.forEach((mesh, i) => {
    mesh.position.set(((i % 6) - 2.5) * 1.9, (1 - Math.floor(i / 6)) * 1.9, 0);
    if (i % every === which) scene.add(mesh);
  });
  const floor = new THREE.Mesh(
    new THREE.PlaneGeometry(30, 30),
    new THREE.MeshStandardMaterial({ color: 0x999999, roughness: 0.7, normalMap }),
  );
  floor.rotation.x = -Math.PI / 2;
  floor.position.y = -3.2;
  scene.add(floor);
  scene.add(new THREE.AmbientLight(0x404050, 0.5));
  if (mix === 'area') RectAreaLightUniformsLib.init();
  const lights = addLights(scene, mix, count, options.penumbra);
  const camera = options.orthographic
    ? new THREE.OrthographicCamera((-4 * width) / height, (4 * width) / height, 4, -4, 0.1, 60)
    : new THREE.PerspectiveCamera(50, width / height, 0.1, 60);
  camera.position.set(0, 2, 11);
  camera.lookAt(0, 0, 0);
  return { scene, camera, lights };
}
