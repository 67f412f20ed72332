import type { FileMap } from '../../assets/collectFiles';
import { listed } from './listed';
import { canDecode, decodePicture, gltfMime } from './decodePicture';
import { encodePng } from './encodePng';
import type { GltfBuffer } from './GltfBuffer';
import type { ObjFolder } from './ObjFolder';
import type { MtlMap } from './parseMtl';
import { holdsNormals, isCutOut, type Picture, withOpacity } from './pictures';

/** Extensions tried for a missing image: textures are often converted to another format. */
const PICTURES = ['.png', '.jpg', '.jpeg', '.tga', '.webp', '.bmp'];

/** A texture of a glTF, as a material refers to it. */
export interface TextureInfo {
  readonly index: number;
  readonly scale?: number;
  readonly extensions?: object;
}

/** Textures of an OBJ's materials as images of a glTF; each file is added once per conversion. */
export class ObjTextures {
  readonly images: object[] = [];
  readonly textures: object[] = [];
  /** Samplers of the glTF: the first repeats, the second clamps. */
  readonly samplers = [
    { wrapS: 10497, wrapT: 10497, magFilter: 9729, minFilter: 9987 },
    { wrapS: 33071, wrapT: 33071, magFilter: 9729, minFilter: 9987 },
  ];
  /** Missing files, by their paths as written in the MTL file. */
  readonly missing = new Set<string>();
  readonly damaged = new Set<string>();
  readonly used = new Set<string>();
  usesTransform = false;

  private readonly imageNumbers = new Map<string, Promise<number | null>>();
  /** Cached results of `isCutOut`, by image key. */
  private readonly cutOuts = new Map<string, boolean>();
  private readonly normals = new Map<string, boolean>();
  private readonly textureNumbers = new Map<string, number>();

  constructor(
    private readonly files: FileMap,
    private readonly folder: ObjFolder,
    private readonly buffer: GltfBuffer,
    private readonly signal?: AbortSignal,
  ) {}

  /** Messages about files that are missing or damaged. */
  get notes(): string[] {
    const { missing, damaged } = this;
    const notes: string[] = [];
    if (missing.size > 0)
      notes.push(`these textures were not found: ${listed(missing)}. Drop the whole folder, or all files together.`);
    if (damaged.size > 0)
      notes.push(`these textures cannot be read: ${listed(damaged)}. Save them anew, as PNG or JPEG.`);
    return notes;
  }

  /** Path of a map's file; null, and recorded as missing, when not found. @param from - path of the MTL file */
  find(from: string, map: MtlMap): string | null {
    const path = this.folder.find(from, map.path, PICTURES);
    if (path === null) this.missing.add(map.path);
    else this.used.add(path);
    return path;
  }

  /** Decoded image; null, and recorded, when it cannot be decoded. */
  async decode(path: string): Promise<Picture | null> {
    this.signal?.throwIfAborted();
    try {
      return await decodePicture(await this.bytesOf(path), path);
    } catch {
      this.damaged.add(path);
      return null;
    }
  }

  /** Adds a file's image unchanged if glTF allows its format, else as PNG. */
  plain(path: string): Promise<number | null> {
    return this.once(path, async () => {
      const bytes = await this.bytesOf(path);
      const mimeType = gltfMime(bytes);
      if (mimeType && (await canDecode(bytes))) return this.addImage(bytes, mimeType, path);
      if (mimeType) this.damaged.add(path);
      const picture = mimeType ? null : await this.decode(path);
      // made opaque, since the alpha channel counts as opacity only where map_d names the picture
      if (picture) for (let at = 3; at < picture.data.length; at += 4) picture.data[at] = 255;
      return picture && this.addPicture(picture, path);
    });
  }

  /** Adds an image computed from others, once for each key. @param make - returns null when a source is damaged */
  made(key: string, name: string, make: () => Promise<Picture | null>): Promise<number | null> {
    return this.once(key, async () => {
      const picture = await make();
      return picture && this.addPicture(picture, name);
    });
  }

  /**
   * An image with the colours of one file and the opacity of another; null when `opacity` cannot be decoded.
   * @param colour - white when null
   */
  async withOpacity(colour: string | null, opacity: string): Promise<{ image: number; isCutOut: boolean } | null> {
    const key = `${colour} with opacity ${opacity}`;
    const image = await this.made(key, colour ?? opacity, async () => {
      const opacities = await this.decode(opacity);
      const colours = colour === null ? null : await this.decode(colour);
      const picture = opacities && withOpacity(colours, opacities);
      if (picture) this.cutOuts.set(key, isCutOut(picture));
      return picture;
    });
    return image === null ? null : { image, isCutOut: this.cutOuts.get(key)! };
  }

  /** Whether the picture of a file holds normals; false, too, when it cannot be decoded. */
  async holdsNormals(path: string): Promise<boolean> {
    let holds = this.normals.get(path);
    if (holds === undefined) {
      const picture = await this.decode(path);
      this.normals.set(path, (holds = picture !== null && holdsNormals(picture)));
    }
    return holds;
  }

  /** A glTF texture of an image, with the map's placement. */
  texture(image: number, map: MtlMap): TextureInfo {
    const sampler = map.isClamped ? 1 : 0;
    const key = `${image} ${sampler}`;
    let index = this.textureNumbers.get(key);
    if (index === undefined) {
      index = this.textures.push({ source: image, sampler }) - 1;
      this.textureNumbers.set(key, index);
    }
    const [[su, sv], [ou, ov]] = [map.scale, map.offset];
    if (su === 1 && sv === 1 && ou === 0 && ov === 0) return { index };
    this.usesTransform = true;
    // v counts from the bottom in OBJ, from the top in glTF
    return { index, extensions: { KHR_texture_transform: { offset: [ou, 1 - sv - ov], scale: [su, sv] } } };
  }

  private once(key: string, make: () => Promise<number | null>): Promise<number | null> {
    let made = this.imageNumbers.get(key);
    if (!made) this.imageNumbers.set(key, (made = make()));
    return made;
  }

  private async bytesOf(path: string): Promise<Uint8Array<ArrayBuffer>> {
    return new Uint8Array(await this.files.get(path)!.arrayBuffer());
  }

  private async addPicture(picture: Picture, name: string): Promise<number> {
    this.signal?.throwIfAborted();
    return this.addImage(await encodePng(picture), 'image/png', name);
  }

  private addImage(bytes: Uint8Array, mimeType: string, path: string): number {
    const name = path.slice(path.lastIndexOf('/') + 1);
    return this.images.push({ name, mimeType, bufferView: this.buffer.addBytes(bytes) }) - 1;
  }
}
