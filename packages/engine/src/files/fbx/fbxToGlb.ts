import { shortText } from '@farol/editing';
import {
  type BufferAttribute,
  type BufferGeometry,
  type Color,
  type Group,
  type Material,
  type Mesh,
  type MeshPhongMaterial,
  MeshStandardMaterial,
  type Object3D,
  type Texture,
} from 'three';
import type { FBXLoader } from 'three/addons/loaders/FBXLoader.js';
import type { FileMap } from '../../assets/collectFiles';
import { binaryOf, readGltfJson } from '../../guard/gltf/readGltfJson';
import { checkSignature } from '../../guard/signature';
import { GltfBuffer } from '../obj/GltfBuffer';
import { gltfOfMtl } from '../obj/gltfOfMtl';
import { ObjFolder } from '../obj/ObjFolder';
import { ObjTextures } from '../obj/ObjTextures';
import type { PackedObj } from '../obj/PackedObj';
import type { MtlMaterial } from '../obj/parseMtl';
import { padded, writeGlb } from '../writeGlb';
import { checkFbx } from '../../guard/fbx/checkFbx';
import { FbxTextures } from './FbxTextures';

/** Metres in the default unit of FBX files (a centimetre). */
const UNIT = 0.01;

/** Greatest size of a file (bytes): buffers are held twice during packing. */
const LARGEST = 2 ** 30;

const nameOf = (path: string): string => path.slice(path.lastIndexOf('/') + 1);

type Triple = readonly [number, number, number];

/** Parses an FBX. The loader's warnings are added to `notes` and kept off the console. */
function parse(loader: FBXLoader, bytes: ArrayBuffer, notes: Set<string>): Group {
  const { warn, error } = console;
  const note = (...said: readonly unknown[]): void => {
    const text = said.map((each) => shortText(String(each), 120)).join(' ');
    notes.add(text.replace(/^(THREE\.)?FBXLoader:?\s*/, ''));
  };
  console.warn = note;
  console.error = note;
  try {
    return loader.parse(bytes, '');
  } catch (cause) {
    throw readError(cause);
  } finally {
    console.warn = warn;
    console.error = error;
  }
}

/** Turns an error of the FBX loader into one sentence. */
function readError(cause: unknown): Error {
  const said = cause instanceof Error ? cause.message.replace(/^THREE\.\w+:\s*/, '') : String(cause);
  const isRaw = cause instanceof TypeError || cause instanceof RangeError;
  const reason = isRaw ? 'something in it is missing, or of another kind than FBX says' : shortText(said, 160);
  return new Error(`its FBX data cannot be read (${reason}): export it again as FBX 7.4, or as glTF.`, { cause });
}

const triple = (colour: Color): Triple => {
  const { r, g, b } = colour.clone().convertLinearToSRGB();
  return [r, g, b];
};

/** Converts an FBX material to an MTL material. */
function mtlOf(material: MeshPhongMaterial, textures: FbxTextures): MtlMaterial {
  const { name, color, emissive, specular, shininess, opacity, bumpScale, emissiveIntensity } = material;
  const map = (texture: Texture | null | undefined, bump?: number): ReturnType<FbxTextures['mapOf']> =>
    textures.mapOf(texture, bump);
  return {
    name,
    // rounding may exceed 1, which glTF does not allow
    diffuse: triple(color).map((channel) => Math.min(1, channel)) as unknown as Triple,
    ...(specular ? { specular: triple(specular), shininess } : {}),
    emissive: triple(emissive.clone().multiplyScalar(emissiveIntensity)),
    opacity,
    diffuseMap: map(material.map),
    specularMap: map(material.specularMap),
    emissiveMap: map(material.emissiveMap),
    opacityMap: map(material.alphaMap),
    normalMap: map(material.normalMap),
    bumpMap: map(material.bumpMap, bumpScale),
    displacementMap: map(material.displacementMap),
  };
}

/** Flips v, which glTF counts from the top, and normalises normals. */
function prepareGeometry(geometry: BufferGeometry): void {
  for (const name of ['uv', 'uv1', 'uv2', 'uv3']) {
    const uv = geometry.getAttribute(name) as BufferAttribute | undefined;
    for (let i = 0, count = uv?.count ?? 0; i < count; i++) uv!.setY(i, 1 - uv!.getY(i));
  }
  if (geometry.getAttribute('normal')) geometry.normalizeNormals();
  else geometry.computeVertexNormals();
}

/** Replaces FBX materials by plain ones, with an index in `userData`. @returns the FBX materials by that index */
function replaceMaterials(root: Object3D): MeshPhongMaterial[] {
  const given: Material[] = [];
  const plain: MeshStandardMaterial[] = [];
  const geometries = new Set<BufferGeometry>();
  const standIn = (material: Material): MeshStandardMaterial => {
    let at = given.indexOf(material);
    if (at < 0) {
      at = given.push(material) - 1;
      const { vertexColors } = material;
      plain.push(new MeshStandardMaterial({ name: material.name, vertexColors, userData: { fbx: at } }));
    }
    return plain[at];
  };
  root.traverse((object) => {
    if (!('isMesh' in object)) return;
    const mesh = object as Mesh;
    geometries.add(mesh.geometry);
    mesh.material = Array.isArray(mesh.material) ? mesh.material.map(standIn) : standIn(mesh.material);
  });
  geometries.forEach(prepareGeometry);
  return given as MeshPhongMaterial[];
}

interface MaterialJson {
  readonly extras?: { readonly fbx?: number };
}

interface GltfOut {
  materials?: MaterialJson[];
  images?: object[];
  textures?: object[];
  samplers?: object[];
  bufferViews?: object[];
  buffers?: { byteLength: number }[];
  extensionsUsed?: string[];
}

/** Converts an FBX file to GLB, see `packFbx`. */
export async function fbxToGlb(files: FileMap, path: string, signal?: AbortSignal): Promise<PackedObj> {
  const given = files.get(path)!;
  if (given.size > LARGEST)
    throw new Error('it has more than 1 GB, which is too large to be packed: export it in parts.');
  const [{ FBXLoader }, { GLTFExporter }, bytes] = await Promise.all([
    import('three/addons/loaders/FBXLoader.js'),
    import('three/addons/exporters/GLTFExporter.js'),
    given.arrayBuffer(),
  ]);
  signal?.throwIfAborted();
  checkSignature(bytes, 'FBX');
  try {
    await checkFbx(bytes, signal);
  } catch (cause) {
    signal?.throwIfAborted();
    throw readError(cause);
  }
  const found = new FbxTextures();
  const warnings = new Set<string>();
  const group = parse(new FBXLoader(found.manager), bytes, warnings);
  signal?.throwIfAborted();
  const all = await found.unpack(files);
  const scale = (group.userData.unitScaleFactor as number | undefined) ?? 1;
  group.scale.multiplyScalar(scale * UNIT);
  group.name = nameOf(path).replace(/\.\w+$/, '');
  group.userData = {};
  const materials = replaceMaterials(group);

  const options = { binary: true, onlyVisible: false, animations: group.animations };
  const packed = (await new GLTFExporter().parseAsync(group, options)) as ArrayBuffer;
  signal?.throwIfAborted();

  const json = readGltfJson(packed) as unknown as GltfOut;
  const binary = binaryOf(packed) ?? new Uint8Array(0);
  const pictures = new GltfBuffer();
  const textures = new ObjTextures(all, new ObjFolder(all), pictures, signal);
  const gltf = { usesEmissiveStrength: false };
  const made = await Promise.all(materials.map((material) => gltfOfMtl(mtlOf(material, found), path, textures, gltf)));
  json.materials = json.materials?.map((each) => {
    const { fbx } = each.extras ?? {};
    return fbx === undefined ? each : (made[fbx] as MaterialJson);
  });
  addPictures(json, binary, pictures, textures);
  const extensions = new Set([
    ...(json.extensionsUsed ?? []),
    ...(gltf.usesEmissiveStrength ? ['KHR_materials_emissive_strength'] : []),
    ...(textures.usesTransform ? ['KHR_texture_transform'] : []),
  ]);
  if (extensions.size > 0) json.extensionsUsed = [...extensions];

  const parts = [binary, ...pictures.parts];
  const length = padded(binary.length) + pictures.length;
  return {
    glb: writeGlb(JSON.stringify(json), parts, length),
    notes: notesOf(nameOf(path), textures, warnings),
    used: new Set([...textures.used].filter((each) => files.has(each))),
  };
}

/** Appends images to the buffer of a glTF. */
function addPictures(json: GltfOut, binary: Uint8Array, pictures: GltfBuffer, textures: ObjTextures): void {
  const before = json.bufferViews?.length ?? 0;
  const start = padded(binary.length);
  const views = pictures.views.map((view) => {
    const { byteOffset, ...others } = view as { byteOffset: number };
    return { ...others, byteOffset: start + byteOffset };
  });
  json.bufferViews = [...(json.bufferViews ?? []), ...views];
  json.buffers = [{ byteLength: start + pictures.length }];
  if (textures.images.length === 0) return;
  json.images = textures.images.map((image) => {
    const { bufferView, ...others } = image as { bufferView: number };
    return { ...others, bufferView: before + bufferView };
  });
  json.textures = textures.textures;
  json.samplers = textures.samplers;
}

function notesOf(name: string, textures: ObjTextures, warnings: ReadonlySet<string>): string[] {
  const notes = textures.notes;
  for (const warning of [...warnings].slice(0, 4)) notes.push(`of three's FBXLoader: ${warning}`);
  return notes.map((note) => `${name}: ${note}`);
}
