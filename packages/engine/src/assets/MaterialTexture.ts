import { LinearSRGBColorSpace, Matrix3, NoColorSpace, SRGBColorSpace, type Texture, type Wrapping } from 'three';

/** Turns what has its first row at the top upside down: v becomes 1 - v. */
const upsideDown = new Matrix3().set(1, 0, 0, 0, -1, 1, 0, 0, 1);

/** Whether a texture, such as one of KTX2, has its first row at the top, and cannot be turned when it is read. */
export const isTopDown = (texture: Texture): boolean => texture.userData.isTopDown === true;

/** A texture as one map of one material has it: its own place on the surface, over the picture of a shared texture. */
export class MaterialTexture {
  readonly three: Texture;

  /** @param isColour - its bytes are sRGB; else they are data */
  constructor(
    private readonly base: Texture,
    wrapS: Wrapping,
    wrapT: Wrapping,
    isColour: boolean,
  ) {
    const texture = (this.three = base.clone());
    texture.wrapS = wrapS;
    texture.wrapT = wrapT;
    // what is read as linear light, such as HDR, stays so
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

  /** Gives the GPU memory back, unless others share it. */
  dispose(): void {
    this.three.dispose();
  }
}
