import * as THREE from 'three';
import { GLTFExporter } from 'three/addons/exporters/GLTFExporter.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { instanced, morphed, skinned } from '../materialScene';
import type { Cases } from './Case';
import * as textures from './textures';

const { MeshPhysicalMaterial: Physical, MeshStandardMaterial: Standard } = THREE;
const ball = new THREE.SphereGeometry(0.65, 24, 16);
const on = (parameters: THREE.MeshPhysicalMaterialParameters) => new THREE.Mesh(ball, new Physical(parameters));

/** A texture as GLTFExporter takes it: the exporter draws a map to a canvas, which needs an image. */
function asImage(make: () => THREE.DataTexture): () => THREE.CanvasTexture {
  return () => {
    const data = make();
    const { width, height } = data.image;
    const canvas = document.createElement('canvas');
    canvas.width = width;
    canvas.height = height;
    const pixels = new Uint8ClampedArray(data.image.data as Uint8Array);
    canvas.getContext('2d')!.putImageData(new ImageData(pixels, width, height), 0, 0);
    const texture = new THREE.CanvasTexture(canvas);
    texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
    texture.colorSpace = data.colorSpace;
    return texture;
  };
}
const colourMap = asImage(textures.colourMap);
const greyMap = asImage(textures.greyMap);
const normalMap = asImage(textures.normalMap);

/** Objects that are written to a file and read back, by the extension that they use. */
const written: Record<string, () => THREE.Object3D> = {
  KHR_materials_clearcoat: () =>
    on({ color: 0xaa4422, clearcoat: 0.9, clearcoatRoughness: 0.2, clearcoatMap: greyMap() }),
  KHR_materials_sheen: () =>
    on({ color: 0x224466, sheen: 1, sheenColor: new THREE.Color(0.7, 0.4, 0.3), sheenRoughness: 0.5 }),
  KHR_materials_transmission: () => on({ transmission: 0.9, thickness: 0.5, roughness: 0.2, attenuationDistance: 2 }),
  KHR_materials_iridescence: () => on({ metalness: 0.8, roughness: 0.3, iridescence: 0.9, iridescenceIOR: 1.5 }),
  KHR_materials_anisotropy: () => on({ metalness: 0.9, roughness: 0.4, anisotropy: 0.7, anisotropyRotation: 0.5 }),
  KHR_materials_specular: () =>
    on({ color: 0x445566, specularIntensity: 0.7, specularColor: new THREE.Color(0.9, 0.5, 0.3), ior: 1.7 }),
  KHR_materials_emissive_strength: () => on({ emissive: 0x884422, emissiveIntensity: 3, roughness: 0.6 }),
  KHR_materials_unlit: () => new THREE.Mesh(ball, new THREE.MeshBasicMaterial({ color: 0xffaa44, map: colourMap() })),
  KHR_texture_transform: () => {
    const map = colourMap();
    map.repeat.set(2, 2);
    map.offset.set(0.3, 0.1);
    map.rotation = 0.4;
    return new THREE.Mesh(ball, new Standard({ map, normalMap: normalMap(), roughness: 0.6 }));
  },
  'metal, roughness and occlusion maps': () => {
    const maps = greyMap();
    return new THREE.Mesh(ball, new Standard({ metalnessMap: maps, roughnessMap: maps, aoMap: maps, metalness: 0.8 }));
  },
  'alpha mask, both sides': () =>
    new THREE.Mesh(ball, new Standard({ map: colourMap(), alphaTest: 0.4, opacity: 0.8, side: THREE.DoubleSide })),
  'alpha blend': () => new THREE.Mesh(ball, new Standard({ color: 0x88ff88, transparent: true, opacity: 0.5 })),
  skin: () => skinned(new Standard({ color: 0xddccbb, roughness: 0.4 })),
  'morph targets and vertex colours': () => morphed(new Standard({ vertexColors: true, roughness: 0.5 })),
  EXT_mesh_gpu_instancing: () => instanced(new Standard({ color: 0xccccff, roughness: 0.5 })),
};

/** Brings a model into a cell. */
function fitted(model: THREE.Object3D): THREE.Object3D {
  model.updateMatrixWorld(true);
  const box = new THREE.Box3().setFromObject(model);
  const size = box.getSize(new THREE.Vector3());
  const holder = new THREE.Group();
  holder.scale.setScalar(1.3 / Math.max(size.x, size.y, size.z));
  model.position.sub(box.getCenter(new THREE.Vector3()));
  holder.add(model);
  return holder;
}

/** Models read by GLTFLoader, as it makes them: one each of what glTF has, and those of public/models. */
export async function gltfCases(): Promise<Cases> {
  const loader = new GLTFLoader();
  const exporter = new GLTFExporter();
  const cases: Cases = {};
  for (const [name, make] of Object.entries(written)) {
    const file = (await exporter.parseAsync(make(), { binary: true })) as ArrayBuffer;
    const { scene } = await loader.parseAsync(file, '');
    cases[name] = () => fitted(scene);
  }
  const { scene } = await loader.loadAsync('models/streetLamp.glb');
  cases['public/models/streetLamp.glb'] = () => fitted(scene);
  return cases;
}
