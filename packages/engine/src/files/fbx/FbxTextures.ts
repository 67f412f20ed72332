import { ClampToEdgeWrapping, LoadingManager, type Texture, Texture as EmptyTexture } from 'three';
import type { FileMap } from '../../assets/collectFiles';
import type { MtlMap } from '../obj/parseMtl';

const endingOfType: Readonly<Record<string, string>> = {
  'image/png': '.png',
  'image/jpeg': '.jpg',
  'image/webp': '.webp',
  'image/bmp': '.bmp',
  'image/tga': '.tga',
  'image/tiff': '.tif',
};

/** Records the images that an FBXLoader requests, without loading; embedded images become files. */
export class FbxTextures {
  readonly manager = new LoadingManager();

  private readonly addresses = new Map<Texture, string>();
  private readonly paths = new Map<string, string>();

  constructor() {
    const { addresses } = this;
    const loader = {
      path: '',
      setPath(): void {},
      load(address: string): Texture {
        const texture = new EmptyTexture();
        addresses.set(texture, address);
        return texture;
      },
    };
    this.manager.addHandler(/./, loader as never);
  }

  /** Extracts the images that are embedded in the FBX. @returns `files` and the extracted images */
  async unpack(files: FileMap): Promise<FileMap> {
    const all = new Map(files);
    for (const address of this.addresses.values()) {
      if (this.paths.has(address)) continue;
      if (!/^(blob|data):/.test(address)) {
        this.paths.set(address, address);
        continue;
      }
      const blob = await (await fetch(address)).blob();
      if (address.startsWith('blob:')) URL.revokeObjectURL(address);
      const path = `inside the FBX ${this.paths.size + 1}${endingOfType[blob.type] ?? '.png'}`;
      this.paths.set(address, path);
      all.set(path, new File([blob], path));
    }
    return all;
  }

  /** Describes a material's texture as a map of an MTL file with the same image and placement. */
  mapOf(texture: Texture | null | undefined, bump = 1): MtlMap | undefined {
    const address = texture ? this.addresses.get(texture) : undefined;
    const path = address === undefined ? undefined : this.paths.get(address);
    if (!texture || path === undefined) return undefined;
    const { repeat, offset, wrapS } = texture;
    return {
      path,
      scale: [repeat.x, repeat.y],
      offset: [offset.x, offset.y],
      isClamped: wrapS === ClampToEdgeWrapping,
      bump,
    };
  }
}
