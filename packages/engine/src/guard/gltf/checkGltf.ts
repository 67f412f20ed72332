import { counted } from '../../base/counted';
import { checkGltfNodes } from './checkGltfNodes';
import { GltfLists } from './GltfLists';
import type { GltfJson } from './readGltfJson';

/** Limit on data stored compressed, shared or not at all (zeros): the larger of `FREE` bytes and `RATIO` × the file. */
const FREE = 64 * 2 ** 20;
const RATIO = 100;

/** Greatest number of morph targets of a primitive (layers of a texture), and of vertices of all morph targets. */
const TARGETS = 2048;
const TARGET_VERTICES = 100_000_000;

const COMPONENTS: Record<number, number> = { 5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4 };
const ITEMS: Record<string, number> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT2: 4, MAT3: 9, MAT4: 16 };

export interface GltfSizes {
  /** Bytes of the GLB's own buffer; null when it has none. */
  readonly binary: number | null;
  /** Size of the resource that an address in the file names (bytes); null when not known. */
  sizeOf?(uri: string): number | null;
}

/**
 * Checks a glTF before a loader allocates memory for it: that references exist, that data lie within their buffers,
 * that nodes form a tree, and that no size is absurd. Covers only the parts that three's loader reads.
 * @throws Error of one sentence: what is wrong, and where
 * @see glTF 2.0, 3 to 5
 */
export function checkGltf(json: GltfJson, sizes: GltfSizes): void {
  const lists = new GltfLists(json);
  const lengths = checkBuffers(lists, sizes);
  checkViews(lists, lengths);
  checkAccessors(lists);
  checkMeshes(lists);
  checkGltfNodes(lists);
  checkAnimations(lists);
  checkTextures(lists);
}

function checkBuffers(lists: GltfLists, { binary, sizeOf }: GltfSizes): number[] {
  return lists.all('buffers').map(({ uri, byteLength, extensions }, i) => {
    const what = `buffer ${i}`;
    const length = lists.whole(byteLength, `the length of ${what}`);
    if (uri !== undefined && typeof uri !== 'string') lists.fail(`the address of ${what} is not text`);
    // a placeholder buffer for compressed data has no bytes of its own
    const isEmpty = Object.values(lists.record(extensions)).some((each) => lists.record(each).fallback === true);
    const there = typeof uri === 'string' ? (sizeOf?.(uri) ?? null) : i === 0 ? binary : isEmpty ? null : 0;
    if (there !== null && length > there && !isEmpty) {
      lists.fail(`${what} says ${counted(length)} bytes, and has ${counted(there)}: it is cut short`);
    }
    return length;
  });
}

/** Name of the extension by which meshopt compresses a view; null for other views. */
function meshoptOf(lists: GltfLists, view: Record<string, unknown>): Record<string, unknown> | null {
  const [found] = Object.entries(lists.record(view.extensions)).filter(([name]) =>
    name.endsWith('_meshopt_compression'),
  );
  return found ? lists.record(found[1]) : null;
}

function checkViews(lists: GltfLists, lengths: readonly number[]): void {
  let sum = 0;
  const packed = lengths.reduce((total, length) => total + length, 0);
  lists.all('bufferViews').forEach((view, i) => {
    const what = `buffer view ${i}`;
    const within = (part: Record<string, unknown>): number => {
      const buffer = lists.index(part.buffer, 'buffers', what);
      const length = lists.whole(part.byteLength, `the length of ${what}`);
      const end = lists.whole(part.byteOffset ?? 0, `the offset of ${what}`) + length;
      if (end > lengths[buffer]) {
        lists.fail(`${what} ends at byte ${counted(end)} of a buffer of ${counted(lengths[buffer])}`);
      }
      return length;
    };
    sum += within(view);
    if (view.byteStride !== undefined && lists.whole(view.byteStride, `the stride of ${what}`) > 252) {
      lists.fail(`the stride of ${what} is more than 252 bytes`);
    }
    const meshopt = meshoptOf(lists, view);
    if (!meshopt) return;
    const from = within(meshopt);
    const to =
      lists.whole(meshopt.count, `the count of ${what}`) * lists.whole(meshopt.byteStride, `the stride of ${what}`);
    if (to > Math.max(FREE, from * RATIO))
      lists.fail(`${what} would be unpacked from ${counted(from)} to ${counted(to)} bytes`);
    sum += to;
  });
  if (sum > Math.max(FREE, packed * RATIO)) {
    lists.fail(`its buffer views come to ${counted(sum)} bytes of buffers that have ${counted(packed)}`);
  }
}

function checkAccessors(lists: GltfLists): void {
  const views = lists.all('bufferViews');
  const inDraco = dracoAccessors(lists);
  let zeros = 0;
  let sum = 0;
  lists.all('accessors').forEach((accessor, i) => {
    const what = `accessor ${i}`;
    const component = COMPONENTS[accessor.componentType as number];
    const items = Object.hasOwn(ITEMS, String(accessor.type)) ? ITEMS[accessor.type as string] : 0;
    if (!component || !items) lists.fail(`${what} has an unknown type`);
    const count = lists.whole(accessor.count, `the count of ${what}`);
    const size = component * items;
    const fits = (part: Record<string, unknown>, wanted: number, bytes: number): void => {
      const view = views[lists.index(part.bufferView, 'bufferViews', what)];
      const stride = part === accessor ? ((view.byteStride as number | undefined) ?? bytes) : bytes;
      const offset = lists.whole(part.byteOffset ?? 0, `the offset of ${what}`);
      const end = wanted === 0 ? 0 : offset + Math.max(stride, 1) * (wanted - 1) + bytes;
      const room = view.byteLength as number;
      if (end > room) {
        lists.fail(
          `${what} has ${counted(wanted)} values, more than fit into the ${counted(room)} bytes of its buffer view`,
        );
      }
    };
    if (accessor.bufferView !== undefined) {
      fits(accessor, count, size);
      sum += count * size;
    } else if (!inDraco.has(i)) zeros += count * size;
    if (accessor.sparse === undefined) return;
    const sparse = lists.record(accessor.sparse);
    const changed = lists.whole(sparse.count, `the sparse count of ${what}`);
    if (changed > count) lists.fail(`${what} changes more values than it has`);
    const indices = lists.record(sparse.indices);
    fits(indices, changed, COMPONENTS[indices.componentType as number] ?? 4);
    fits(lists.record(sparse.values), changed, size);
  });
  // their sum is limited, since each accessor becomes a buffer on the GPU, and sparse ones are copied
  const packed = lists.all('buffers').reduce((total, { byteLength }) => total + (byteLength as number), 0);
  if (sum > Math.max(FREE, packed * RATIO)) {
    lists.fail(`its accessors come to ${counted(sum)} bytes of buffers that have ${counted(packed)}`);
  }
  if (zeros > FREE) lists.fail(`its accessors without data come to ${counted(zeros)} bytes of zeros`);
}

function primitivesOf(lists: GltfLists, mesh: Record<string, unknown>, what: string): Record<string, unknown>[] {
  return lists.listOf(mesh.primitives, `the primitives of ${what}`).map((each) => {
    if (typeof each !== 'object' || each === null) lists.fail(`${what} has a primitive that is not an object`);
    const primitive = each as Record<string, unknown>;
    if (typeof primitive.attributes !== 'object' || primitive.attributes === null) {
      lists.fail(`${what} has a primitive without attributes`);
    }
    return primitive;
  });
}

/** Indices of accessors whose values Draco decodes. */
function dracoAccessors(lists: GltfLists): Set<unknown> {
  const found = new Set<unknown>();
  lists.all('meshes').forEach((mesh, i) => {
    for (const primitive of primitivesOf(lists, mesh, `mesh ${i}`)) {
      if (lists.record(primitive.extensions).KHR_draco_mesh_compression === undefined) continue;
      found.add(primitive.indices);
      for (const each of Object.values(lists.record(primitive.attributes))) found.add(each);
    }
  });
  return found;
}

/** Checks morph targets, which three copies to a float texture before a mesh is first drawn. */
function checkTargets(lists: GltfLists, { attributes, targets = [] }: Record<string, unknown>, what: string): number {
  const list = lists.listOf(targets, `the targets of ${what}`);
  if (list.length > TARGETS) {
    lists.fail(`${what} has ${counted(list.length)} morph targets, and ${counted(TARGETS)} is the limit`);
  }
  const { POSITION } = lists.record(attributes);
  const count = POSITION === undefined ? 0 : (lists.all('accessors')[POSITION as number].count as number);
  return list.length * count;
}

function checkMeshes(lists: GltfLists): void {
  let vertices = 0;
  lists.all('meshes').forEach((mesh, i) => {
    const what = `mesh ${i}`;
    for (const primitive of primitivesOf(lists, mesh, what)) {
      const { mode, indices, material } = primitive;
      if (mode !== undefined && (!Number.isInteger(mode) || (mode as number) < 0 || (mode as number) > 6)) {
        lists.fail(`${what} is drawn by the unknown mode ${lists.show(mode)}`);
      }
      const attributes = [primitive.attributes, ...lists.listOf(primitive.targets ?? [], `the targets of ${what}`)];
      for (const each of attributes) {
        for (const accessor of Object.values(lists.record(each))) lists.index(accessor, 'accessors', what);
      }
      if (indices !== undefined) lists.index(indices, 'accessors', what);
      if (material !== undefined) lists.index(material, 'materials', what);
      const draco = lists.record(primitive.extensions).KHR_draco_mesh_compression;
      if (draco !== undefined) lists.index(lists.record(draco).bufferView, 'bufferViews', what);
      vertices += checkTargets(lists, primitive, what);
    }
  });
  if (vertices > TARGET_VERTICES) {
    lists.fail(`its morph targets come to ${counted(vertices)} vertices, and ${counted(TARGET_VERTICES)} is the limit`);
  }
}

function checkAnimations(lists: GltfLists): void {
  lists.all('animations').forEach((animation, i) => {
    const what = `animation ${i}`;
    const samplers = lists.listOf(animation.samplers, `the samplers of ${what}`).map((each) => lists.record(each));
    for (const { input, output } of samplers) {
      lists.index(input, 'accessors', what);
      lists.index(output, 'accessors', what);
    }
    for (const each of lists.listOf(animation.channels, `the channels of ${what}`)) {
      const { sampler, target } = lists.record(each);
      if (!samplers[sampler as number])
        lists.fail(`${what} names the sampler ${lists.show(sampler)}, which it does not have`);
      if (typeof target !== 'object' || target === null) lists.fail(`${what} has a channel without a target`);
      const { node } = lists.record(target);
      if (node !== undefined) lists.index(node, 'nodes', what);
    }
  });
}

function checkTextures(lists: GltfLists): void {
  lists.all('images').forEach(({ uri, bufferView }, i) => {
    if (bufferView !== undefined) lists.index(bufferView, 'bufferViews', `image ${i}`);
    else if (typeof uri !== 'string') lists.fail(`image ${i} has neither an address nor a buffer view`);
  });
  lists.all('textures').forEach(({ source, sampler, extensions }, i) => {
    const sources = Object.values(lists.record(extensions)).map((each) => lists.record(each).source);
    for (const each of [source, ...sources]) if (each !== undefined) lists.index(each, 'images', `texture ${i}`);
    if (sampler !== undefined) lists.index(sampler, 'samplers', `texture ${i}`);
  });
  lists.all('materials').forEach((material, i) => {
    // checks every member named as a texture, in extensions too; the JSON's depth is limited already
    const visit = (value: unknown): void => {
      for (const [key, each] of Object.entries(lists.record(value))) {
        if (typeof each !== 'object' || each === null || key === 'extras') continue;
        if (/texture$/i.test(key)) lists.index(lists.record(each).index, 'textures', `material ${i}`);
        visit(each);
      }
    };
    visit(material);
  });
}
