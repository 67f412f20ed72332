import { LinearSRGBColorSpace, Matrix3, NoColorSpace, SRGBColorSpace, type Texture, type Wrapping } from 'three';

/** UV matrix for textures whose first row is at the top: v becomes 1 - v. */
const upsideDown = new Matrix3().set(1, 0, 0, 0, -1, 1, 0, 0, 1);

/** Whether a texture's first row is at the top and cannot be flipped on loading, as with KTX2. */
export const isTopDown = (texture: Texture): boolean => texture.userData.isTopDown === true;

/** Texture of one map of one material: a UV transform of its own over a shared texture's image. */
export class MaterialTexture {
  readonly three: Texture;

  /** @param isColour - texels are sRGB; else data */
  constructor(
    private readonly base: Texture,
    wrapS: Wrapping,
    wrapT: Wrapping,
    isColour: boolean,
  ) {
    const texture = (this.three = base.clone());
    texture.wrapS = wrapS;
    texture.wrapT = wrapT;
    // textures read as linear light, such as HDR, stay linear
    const isLight = base.colorSpace === LinearSRGBColorSpace;
    texture.colorSpace = isColour ? (isLight ? LinearSRGBColorSpace : SRGBColorSpace) : NoColorSpace;
    texture.matrixAutoUpdate = false;
  }

  isOf(base: Texture, wrapS: Wrapping, wrapT: Wrapping): boolean {
    return base === this.base && wrapS === this.three.wrapS && wrapT === this.three.wrapT;
  }

  /** @param rotation - radians, about the corner where u and v are 0 */
  place(offsetX: number, offsetY: number, repeatX: number, repeatY: number, rotation: number, channel: number): void {
    const { three } = this;
    three.offset.set(offsetX, offsetY);
    three.repeat.set(repeatX, repeatY);
    three.rotation = rotation;
    three.channel = channel;
    three.center.set(0, 0);
    three.updateMatrix();
    if (isTopDown(this.base)) three.matrix.premultiply(upsideDown);
  }

  /** Frees the GPU memory, unless shared. */
  dispose(): void {
    this.three.dispose();
  }
}
