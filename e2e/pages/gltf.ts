import { type Light, type Material, type Mesh, PerspectiveCamera, Texture, WebGLRenderer } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

/** Content of a GLB by three's own loader, and its picture by three's own renderer. */
export interface ReadGltf {
  lights: { name: string; type: string; intensity: number }[];
  meshes: string[];
  cameras: number;
  textures: number;
  skinned: number;
  /** RGBA bytes, top row first, as base64. */
  picture: string;
}

declare global {
  interface Window {
    /** Reads a GLB (base64) and draws it by its first camera. */
    readGltf(glb: string, width: number, height: number): Promise<ReadGltf>;
  }
}

const webgl = new WebGLRenderer({ antialias: true });
document.body.append(webgl.domElement);

window.readGltf = async (glb, width, height) => {
  const bytes = Uint8Array.from(atob(glb), (letter) => letter.charCodeAt(0));
  const { scene, cameras } = await new GLTFLoader().parseAsync(bytes.buffer, '');
  const found: ReadGltf = { lights: [], meshes: [], cameras: cameras.length, textures: 0, skinned: 0, picture: '' };
  const textures = new Set<Texture>();
  scene.traverse((object) => {
    const { name, type } = object;
    if ('isLight' in object) found.lights.push({ name, type, intensity: (object as Light).intensity });
    if (!('isMesh' in object)) return;
    found.meshes.push(name);
    if ('isSkinnedMesh' in object) found.skinned++;
    for (const value of Object.values((object as Mesh).material as Material)) {
      if (!(value instanceof Texture)) continue;
      textures.add(value);
      // glTF stores no anisotropy: this is what the editor's own textures have
      value.anisotropy = 8;
    }
  });
  found.textures = textures.size;
  const camera = cameras.find((each) => each instanceof PerspectiveCamera) ?? new PerspectiveCamera();
  if (camera instanceof PerspectiveCamera) {
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
  }
  webgl.setSize(width, height, false);
  webgl.render(scene, camera);
  const copy = document.createElement('canvas');
  copy.width = width;
  copy.height = height;
  const context = copy.getContext('2d', { willReadFrequently: true })!;
  context.drawImage(webgl.domElement, 0, 0);
  const { data } = context.getImageData(0, 0, width, height);
  const letters: string[] = [];
  for (let i = 0; i < data.length; i += 8192) letters.push(String.fromCharCode(...data.subarray(i, i + 8192)));
  found.picture = btoa(letters.join(''));
  return found;
};
