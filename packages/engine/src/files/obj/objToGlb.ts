import type { FileMap } from '../../assets/collectFiles';
import { checkSignature } from '../../guard/signature';
import { Slices } from '../../base/Slices';
import { padded, writeGlb } from '../writeGlb';
import { GltfBuffer } from './GltfBuffer';
import { gltfOfMtl, greyMaterial } from './gltfOfMtl';
import { ObjFolder } from './ObjFolder';
import { objMeshes } from './objMeshes';
import { listed } from './listed';
import { ObjTextures } from './ObjTextures';
import type { PackedObj } from './PackedObj';
import { type MtlMaterial, parseMtl } from './parseMtl';
import { readerOf } from './readers';

/** A material and the path of its MTL file. */
interface FoundMaterial {
  readonly material: MtlMaterial;
  readonly from: string;
}

/** Largest buffer (bytes) that every browser can allocate. */
const LARGEST = 2 ** 31 - 1;

const nameOf = (path: string): string => path.slice(path.lastIndexOf('/') + 1);

/** Packs an OBJ, STL or PLY into a GLB: the code that `packObj` loads when first needed. */
export async function objToGlb(files: FileMap, path: string, signal?: AbortSignal): Promise<PackedObj> {
  const given = files.get(path)!;
  if (given.size > LARGEST)
    throw new Error('it has more than 2 GB, which no browser reads at once: export it in parts.');
  const bytes = new Uint8Array(await given.arrayBuffer());
  checkSignature(bytes.buffer, path.slice(path.lastIndexOf('.') + 1).toUpperCase());
  const { read, hasMaterials } = readerOf(path);
  const file = await read(bytes, signal);
  const meshes = await objMeshes(file, signal);
  const folder = new ObjFolder(files);
  const buffer = new GltfBuffer();
  const textures = new ObjTextures(files, folder, buffer, signal);
  const used = new Set<string>();
  const notes: string[] = [];
  const table = hasMaterials
    ? await readMaterials(files, folder, path, file.materialFiles, used, notes)
    : new Map<string, FoundMaterial>();

  const materials: object[] = [];
  const numbers = new Map<string | null, number>();
  const gltf = { usesEmissiveStrength: false };
  const unknown = new Set<string>();
  const numberOf = async (name: string | null): Promise<number> => {
    let number = numbers.get(name);
    if (number !== undefined) return number;
    const found = name === null ? undefined : table.get(name);
    if (!found && name !== null && table.size > 0) unknown.add(name);
    number =
      materials.push(found ? await gltfOfMtl(found.material, found.from, textures, gltf) : greyMaterial(name ?? '')) -
      1;
    numbers.set(name, number);
    return number;
  };

  const slices = new Slices(signal);
  const gltfMeshes: object[] = [];
  for (const { name, primitives } of meshes) {
    const list: object[] = [];
    for (const { material, positions, normals, uvs, colours, index } of primitives) {
      if (slices.areOver) await slices.next();
      const attributes = {
        POSITION: buffer.addVertices(positions, 3, true),
        NORMAL: buffer.addVertices(normals, 3),
        ...(uvs ? { TEXCOORD_0: buffer.addVertices(fromTheTop(uvs), 2) } : {}),
        ...(colours ? { COLOR_0: buffer.addVertices(colours, 3) } : {}),
      };
      list.push({
        attributes,
        indices: buffer.addIndex(index, positions.length / 3),
        material: await numberOf(material),
      });
    }
    gltfMeshes.push({ name: name || nameOf(path).replace(/\.\w+$/, ''), primitives: list });
  }

  for (const each of textures.used) used.add(each);
  notes.push(...textures.notes);
  if (unknown.size > 0) notes.push(`these materials are in no MTL file and stay grey: ${listed(unknown)}.`);
  if (file.leftOut > 0) notes.push(`its lines, points and curves were left out.`);
  if (file.coarse > 0) {
    notes.push(`${file.coarse} of its faces have so many corners that they may look wrong: cut them into triangles.`);
  }

  const extensions = [
    ...(gltf.usesEmissiveStrength ? ['KHR_materials_emissive_strength'] : []),
    ...(textures.usesTransform ? ['KHR_texture_transform'] : []),
  ];
  const json = {
    asset: { version: '2.0', generator: 'Farol, from an OBJ, STL or PLY file' },
    ...(extensions.length > 0 ? { extensionsUsed: extensions } : {}),
    scene: 0,
    scenes: [{ nodes: gltfMeshes.map((_, i) => i) }],
    nodes: gltfMeshes.map((mesh, i) => ({ name: (mesh as { name: string }).name, mesh: i })),
    meshes: gltfMeshes,
    materials,
    ...(textures.images.length > 0
      ? { images: textures.images, textures: textures.textures, samplers: textures.samplers }
      : {}),
    accessors: buffer.accessors,
    bufferViews: buffer.views,
    buffers: [{ byteLength: padded(buffer.length) }],
  };
  signal?.throwIfAborted();
  return {
    glb: writeGlb(JSON.stringify(json), buffer.parts, buffer.length),
    notes: notes.map((note) => `${nameOf(path)}: ${note}`),
    used,
  };
}

/** Flips v, which glTF counts from the top. */
function fromTheTop(uvs: Float32Array): Float32Array {
  for (let i = 1; i < uvs.length; i += 2) uvs[i] = 1 - uvs[i];
  return uvs;
}

/** The materials of the MTL files that an OBJ names; if none, of the MTL with the OBJ's name, else of the only MTL. */
async function readMaterials(
  files: FileMap,
  folder: ObjFolder,
  path: string,
  references: readonly string[],
  used: Set<string>,
  notes: string[],
): Promise<Map<string, FoundMaterial>> {
  const paths = new Set<string>();
  const missing: string[] = [];
  for (const reference of references) {
    // the line is first one name, which may have blanks; if there is no such file, each word is a name
    const whole = folder.find(path, reference);
    const found = whole === null ? reference.split(/\s+/).map((each) => [each, folder.find(path, each)] as const) : [];
    if (whole !== null) paths.add(whole);
    for (const [name, each] of found) {
      if (each === null) missing.push(name);
      else paths.add(each);
    }
  }
  if (paths.size === 0) {
    const own = folder.find(path, nameOf(path).replace(/\.obj$/i, '.mtl'));
    const others = folder.ending('.mtl', path);
    if (own !== null) paths.add(own);
    else if (others.length === 1) paths.add(others[0]);
  }
  const table = new Map<string, FoundMaterial>();
  for (const each of paths) {
    used.add(each);
    for (const [name, material] of parseMtl(await files.get(each)!.text())) {
      if (!table.has(name)) table.set(name, { material, from: each });
    }
  }
  if (missing.length > 0 && paths.size === 0) {
    notes.push(`it is grey, since its materials were not found: ${listed(missing)}. Drop them together with it.`);
  } else if (missing.length > 0 && references.length > paths.size) {
    notes.push(`these files of materials were not found: ${listed(missing)}.`);
  } else if (paths.size === 0)
    notes.push('it is grey, since it names no file of materials. Drop its MTL file with it.');
  return table;
}
