import { shortText } from '@farol/editing';
import { counted } from '../../base/counted';
import { unpack } from '../unpack';

/** Limit of the unpacked arrays: `FREE` bytes or `RATIO` times the file's size, whichever is greater. */
const FREE = 64 * 2 ** 20;
const RATIO = 100;

/** Size (bytes) up to which packed arrays are unpacked without a check: they unpack to 4 MB at most. */
const SMALL = 4096;

/** Limit on the squared corner counts of polygons, summed: ear clipping takes quadratic time. */
const CUTTING = 500_000_000;

/** Limit on keys that the loader inserts into rotation curves: one for each half turn between two keys. */
const TURNS = 10_000_000;

/** Greatest nesting depth of FBX nodes. */
const DEEPEST = 200;

const MAGIC = 'Kaydara FBX Binary  \0';

/** Bytes of an array element, by type letter. */
const sizes: Readonly<Record<string, number>> = { b: 1, c: 1, d: 8, f: 4, i: 4, l: 8 };
/** Bytes of a single value, by type letter. */
const singles: Readonly<Record<string, number>> = { C: 1, D: 8, F: 4, I: 4, L: 8, Y: 2 };

/** Names of properties of Object.prototype, refused since the loader would write to the prototype. */
const shared = new Set(Object.getOwnPropertyNames(Object.prototype));

const fail = (problem: string): never => {
  throw new Error(problem);
};

/** Limits the memory and work that an FBX causes. Each method throws an Error whose message is the reason. */
class Budget {
  private bytes = 0;
  private cutting = 0;
  private turns = 0;

  constructor(private readonly fileSize: number) {}

  checkName(name: string): void {
    if (shared.has(name)) fail(`it has an entry of the name ${shortText(name)}`);
  }

  takeBytes(bytes: number): void {
    this.bytes += bytes;
    if (this.bytes > Math.max(FREE, this.fileSize * RATIO)) {
      fail(`its arrays come to more than ${counted(Math.max(FREE, this.fileSize * RATIO))} bytes`);
    }
  }

  /** @param indices - vertex indices of corners, the last of each face negative */
  takeFaces(indices: ArrayLike<number>): void {
    let corners = 0;
    for (let i = 0; i < indices.length; i++) {
      corners++;
      if (indices[i] >= 0 && i < indices.length - 1) continue;
      if (corners > 4) this.cutting += corners * corners;
      if (this.cutting > CUTTING) fail(`a face of it has ${counted(corners)} corners: cut it into triangles`);
      corners = 0;
    }
  }

  /** @param values - values of a curve's keys, which may be angles in degrees */
  takeCurve(values: ArrayLike<number>): void {
    for (let i = 1; i < values.length; i++) {
      const span = Math.abs(values[i] - values[i - 1]);
      if (span >= 180) this.turns += span / 180;
    }
    if (this.turns > TURNS) fail('the keys of its clips are too far from one another');
  }
}

/** A packed array of a node, before it is unpacked. */
interface PackedArray {
  readonly node: string;
  readonly type: string;
  readonly count: number;
  readonly isPacked: boolean;
  readonly bytes: Uint8Array<ArrayBuffer>;
}

/**
 * Parses the nodes of a binary FBX as three's loader does.
 * @throws RangeError where the loader would read beyond the end
 */
function* arraysOf(bytes: ArrayBuffer, budget: Budget): Generator<PackedArray> {
  const view = new DataView(bytes);
  let at = MAGIC.length + 2;
  const word = (): number => view.getUint32((at += 4) - 4, true);
  const isLong = word() >= 7500;
  // the loader reads both halves of a length; no file is long enough to need the upper one
  const length = (): number => (isLong ? word() + word() * 2 ** 32 : word());
  const { byteLength } = bytes;
  const isOver = (): boolean => (byteLength % 16 === 0 ? Math.floor((at + 176) / 16) * 16 : at + 176) >= byteLength;
  const nameOf = (size: number): string =>
    String.fromCharCode(...new Uint8Array(bytes, at, size)).replace(/\0.*$/s, '');
  /** Byte offsets at which the open nodes end, the innermost last. */
  const open: number[] = [];
  while (open.length > 0 || !isOver()) {
    if (open.length > 0 && at >= open.at(-1)!) {
      open.pop();
      continue;
    }
    const end = length();
    const properties = length();
    length();
    const nameLength = view.getUint8(at++);
    const node = nameOf(nameLength);
    at += nameLength;
    if (end === 0) continue;
    budget.checkName(node);
    for (let i = 0; i < properties; i++) {
      const type = String.fromCharCode(view.getUint8(at++));
      if (Object.hasOwn(singles, type)) at += singles[type];
      else if (type === 'S' || type === 'R') {
        const size = word();
        at += size;
      } else if (Object.hasOwn(sizes, type)) {
        const [count, encoding, packed] = [word(), word(), word()];
        const size = encoding === 0 ? count * sizes[type] : packed;
        if (at + size > byteLength) throw new RangeError('Beyond the end.');
        yield { node, type, count, isPacked: encoding !== 0, bytes: new Uint8Array(bytes, at, size) };
        at += size;
      } else throw new RangeError('A type that the loader does not know.');
      if (at > byteLength) throw new RangeError('Beyond the end.');
    }
    open.push(end);
    if (open.length > DEEPEST) fail(`its nodes are more than ${DEEPEST} deep`);
  }
}

/** Unpacks an array of at most `most` bytes. @returns null for damaged data, which the loader reports */
const unpacked = (bytes: Uint8Array<ArrayBuffer>, most: number): Promise<Uint8Array<ArrayBuffer> | null> =>
  unpack(bytes, 'deflate', { most }).catch((error: unknown) =>
    error instanceof RangeError ? fail('its arrays come to more than it says') : null,
  );

const numbersOf = (bytes: Uint8Array<ArrayBuffer>, type: string): ArrayLike<number> => {
  const whole = bytes.slice(0, bytes.length - (bytes.length % sizes[type])).buffer;
  if (type === 'f') return new Float32Array(whole);
  if (type === 'd') return new Float64Array(whole);
  if (type === 'i') return new Int32Array(whole);
  return [];
};

async function checkBinary(bytes: ArrayBuffer, budget: Budget, signal?: AbortSignal): Promise<void> {
  try {
    for (const { node, type, count, isPacked, bytes: data } of arraysOf(bytes, budget)) {
      // three's FBXLoader makes a JavaScript array of the numbers, 8 bytes each
      budget.takeBytes(count * 8);
      const isFaces = node === 'PolygonVertexIndex';
      const isCurve = node === 'KeyValueFloat';
      const mustUnpack = isPacked && (isFaces || isCurve || data.length > SMALL);
      const content = mustUnpack ? await unpacked(data, count * sizes[type] + 2 ** 16) : data;
      signal?.throwIfAborted();
      if (content && isFaces) budget.takeFaces(numbersOf(content, type));
      if (content && isCurve) budget.takeCurve(numbersOf(content, type));
    }
  } catch (error) {
    // a file that ends early is reported by three's FBXLoader
    if (!(error instanceof RangeError)) throw error;
  }
}

function checkText(bytes: ArrayBuffer, budget: Budget): void {
  const text = new TextDecoder('latin1').decode(bytes);
  for (const [, name] of text.matchAll(/^[ \t]*(\w+)[ \t]*:/gm)) budget.checkName(name);
  for (const [, name, list] of text.matchAll(
    /\b(PolygonVertexIndex|KeyValueFloat):[^{}]*\{\s*a:([^a-df-zA-DF-Z:{}]*)/g,
  )) {
    const numbers = list.split(',').map(Number);
    if (name === 'PolygonVertexIndex') budget.takeFaces(numbers);
    else budget.takeCurve(numbers);
  }
}

/**
 * Checks an FBX before three's loader reads it. The loader writes entries of any name into objects, unpacks arrays of
 * any size, triangulates faces of any number of corners, and adds as many keys to a clip as its angles require.
 * @throws Error (as a rejection) whose message is the reason; the signal's abort reason
 */
export async function checkFbx(bytes: ArrayBuffer, signal?: AbortSignal): Promise<void> {
  const budget = new Budget(bytes.byteLength);
  const head = String.fromCharCode(...new Uint8Array(bytes, 0, Math.min(MAGIC.length, bytes.byteLength)));
  if (head === MAGIC) await checkBinary(bytes, budget, signal);
  else checkText(bytes, budget);
}
