import { DataTexture, FloatType, NearestFilter, RGBAFormat, type WebGLRenderer } from 'three';
import type { LightArray } from './LightArray';
import { textureHandle } from '../three/handles';
import { bindTexture, unbindTexture } from '../three/state';
import { unpackAsIs } from '../three/unpackAsIs';

/** Number of lights in each row of the field's texture. */
const WIDTH = 128;
/** Number of textures used in rotation, so that none is written while the GPU may read it for an earlier frame. */
const TURNS = 3;

/** One of the array's textures, and the version of the array that it holds. */
interface Turn {
  readonly texture: DataTexture;
  uploadedVersion: number;
}

/** Copy of a LightArray on one renderer's GPU; uploads only rows that changed. */
export class FieldArray {
  /** Bytes uploaded by the last `upload`. */
  uploadedBytes = 0;
  private readonly turns: Turn[];
  private current = 0;
  private webgl!: WebGLRenderer;

  constructor(private readonly source: LightArray) {
    const { array } = source;
    const rows = Math.max(1, array.length / (WIDTH * 4));
    const data = array.length > 0 ? array : new Float32Array(WIDTH * 4);
    this.turns = Array.from({ length: TURNS }, () => {
      const texture = new DataTexture(data, WIDTH, rows, RGBAFormat, FloatType);
      texture.magFilter = texture.minFilter = NearestFilter;
      texture.needsUpdate = true;
      return { texture, uploadedVersion: 0 };
    });
  }

  /** The texture with the content of the last `upload`. */
  get texture(): DataTexture {
    return this.turns[this.current].texture;
  }

  get bytes(): number {
    return this.texture.image.data!.byteLength * TURNS;
  }

  /** Uploads changed rows among the first `rows`. @param rows - number of rows of 128 lights in use */
  upload(webgl: WebGLRenderer, rows: number): void {
    this.webgl = webgl;
    this.uploadedBytes = 0;
    if (this.source.hasChanged(this.turns[this.current].uploadedVersion, rows))
      this.current = (this.current + 1) % TURNS;
    const turn = this.turns[this.current];
    if (textureHandle(webgl, turn.texture) === undefined) {
      webgl.initTexture(turn.texture);
      turn.uploadedVersion = this.source.whole();
      this.uploadedBytes = this.bytes / TURNS;
    } else if (this.source.hasChanged(turn.uploadedVersion, rows)) {
      bindTexture(webgl, WebGL2RenderingContext.TEXTURE_2D, textureHandle(webgl, turn.texture)!);
      unpackAsIs(webgl, webgl.getContext() as WebGL2RenderingContext);
      turn.uploadedVersion = this.source.changes(turn.uploadedVersion, rows, this.send);
      unbindTexture(webgl);
    }
  }

  dispose(): void {
    for (const { texture } of this.turns) texture.dispose();
  }

  private readonly send = (first: number, rows: number): void => {
    const gl = this.webgl.getContext() as WebGL2RenderingContext;
    const start = first * WIDTH * 4;
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, first, WIDTH, rows, gl.RGBA, gl.FLOAT, this.source.array, start);
    this.uploadedBytes += rows * WIDTH * 16;
  };
}
