import {
  DataTexture,
  NearestFilter,
  RedIntegerFormat,
  RGBAIntegerFormat,
  UnsignedIntType,
  type WebGLRenderer,
} from 'three';
import { withRoom } from './fitTarget';
import { unpackAsIs } from '../three/unpackAsIs';
import { textureHandle } from '../three/handles';
import { bindTexture, unbindTexture } from '../three/state';

/**
 * A texture of unsigned 32-bit words, filled from the caller's array. Grows; uploads the words in use if their version has
 * changed.
 */
export class WordTable {
  texture: DataTexture;
  /** Bytes uploaded by the last `upload`. */
  uploadedBytes = 0;
  /** Version of the words in the texture; -1 for none. */
  private version = -1;

  /** @param channels - number of words in a texel, 1 or 4 */
  constructor(private readonly channels: 1 | 4) {
    this.texture = this.make(1, 1);
  }

  /** Bytes of the texture. */
  get bytes(): number {
    return this.texture.image.width * this.texture.image.height * this.channels * 4;
  }

  /**
   * Uploads the first rows.
   * @param words - row after row, at least width * rows * channels
   * @param width - texels in a row
   * @param version - number, at least 0, that differs from the last upload's if any word may have changed
   */
  upload(webgl: WebGLRenderer, words: Uint32Array, width: number, rows: number, version: number): void {
    const { image } = this.texture;
    const made = withRoom(image.width, width);
    if (image.width !== made || image.height < rows) {
      this.texture.dispose();
      this.texture = this.make(made, withRoom(0, Math.ceil(rows * 1.25) + 1));
    }
    // three has no handle of a new texture, nor of any texture once a lost context is restored: all words are uploaded
    if (textureHandle(webgl, this.texture) === undefined) {
      webgl.initTexture(this.texture);
      this.version = -1;
    }
    this.uploadedBytes = 0;
    if (version === this.version) return;
    this.version = version;
    const gl = webgl.getContext() as WebGL2RenderingContext;
    bindTexture(webgl, gl.TEXTURE_2D, textureHandle(webgl, this.texture)!);
    unpackAsIs(webgl, gl);
    const format = this.channels === 1 ? gl.RED_INTEGER : gl.RGBA_INTEGER;
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, rows, format, gl.UNSIGNED_INT, words, 0);
    unbindTexture(webgl);
    this.uploadedBytes = width * rows * this.channels * 4;
  }

  dispose(): void {
    this.texture.dispose();
  }

  private make(width: number, height: number): DataTexture {
    const format = this.channels === 1 ? RedIntegerFormat : RGBAIntegerFormat;
    const texture = new DataTexture(
      new Uint32Array(width * height * this.channels),
      width,
      height,
      format,
      UnsignedIntType,
    );
    texture.internalFormat = this.channels === 1 ? 'R32UI' : 'RGBA32UI';
    texture.magFilter = texture.minFilter = NearestFilter;
    texture.needsUpdate = true;
    return texture;
  }
}
