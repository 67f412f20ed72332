import { DataTexture, FloatType, NearestFilter, RGBAFormat, type WebGLRenderer } from 'three';
import { unpackAsIs } from '../three/unpackAsIs';
import { textureHandle } from '../three/handles';
import { bindTexture, unbindTexture } from '../three/state';

/** Number of textures used in rotation, so that none is written while the GPU may read it for an earlier frame. */
const TURNS = 3;

/** One of the table's textures, and the range of data not yet uploaded to it. */
interface Slot {
  texture: DataTexture;
  fresh: boolean;
  firstChanged: number;
  lastChanged: number;
}

/**
 * A growable float texture that uploads only rows whose content changed, or, within a single row, only changed texels. Allocates
 * only to grow.
 */
export class DataTable {
  /** The texels, 4 floats each, row after row. */
  data: Float32Array<ArrayBuffer>;
  /** Bytes uploaded by the last `upload`. */
  uploadedBytes = 0;
  private slots: Slot[] = [];
  private current = 0;
  private firstChanged = Infinity;
  private lastChanged = -1;

  /** @param width - texels in a row */
  constructor(readonly width: number) {
    this.data = new Float32Array(width * 4);
    this.makeSlots();
  }

  /** The texture with the content of the last `upload`. */
  get texture(): DataTexture {
    return this.slots[this.current].texture;
  }

  /** Size of the textures in bytes. */
  get bytes(): number {
    return this.data.byteLength * TURNS;
  }

  /** Makes room for a number of floats; content is lost when the table grows. */
  reserve(floats: number): void {
    if (floats <= this.data.length) return;
    let rows = this.data.length / (this.width * 4);
    while (rows * this.width * 4 < floats) rows *= 2;
    this.data = new Float32Array(rows * this.width * 4);
    this.dispose();
    this.makeSlots();
  }

  /** Writes one texel at a float offset, and records whether it changed. */
  set4(at: number, x: number, y: number, z: number, w: number): void {
    const d = this.data;
    x = Math.fround(x);
    y = Math.fround(y);
    z = Math.fround(z);
    w = Math.fround(w);
    if (d[at] === x && d[at + 1] === y && d[at + 2] === z && d[at + 3] === w) return;
    d[at] = x;
    d[at + 1] = y;
    d[at + 2] = z;
    d[at + 3] = w;
    if (at < this.firstChanged) this.firstChanged = at;
    if (at > this.lastChanged) this.lastChanged = at;
  }

  /** Sets the number of floats in use; later ones are not uploaded. */
  used(floats: number): void {
    if (this.lastChanged >= floats) this.lastChanged = floats - 1;
  }

  /** Uploads the rows that changed. Call inside a frame, before draws that read the texture. */
  upload(webgl: WebGLRenderer): void {
    this.uploadedBytes = 0;
    if (this.lastChanged >= this.firstChanged) {
      for (const slot of this.slots) {
        slot.firstChanged = Math.min(slot.firstChanged, this.firstChanged);
        slot.lastChanged = Math.max(slot.lastChanged, this.lastChanged);
      }
      this.firstChanged = Infinity;
      this.lastChanged = -1;
      this.current = (this.current + 1) % TURNS;
    }
    this.send(webgl, this.slots[this.current]);
  }

  dispose(): void {
    for (const slot of this.slots) slot.texture.dispose();
  }

  private send(webgl: WebGLRenderer, slot: Slot): void {
    const handle = textureHandle(webgl, slot.texture);
    const rowFloats = this.width * 4;
    if (slot.fresh || handle === undefined) {
      webgl.initTexture(slot.texture);
      slot.fresh = false;
      this.uploadedBytes = this.data.byteLength;
    } else if (slot.lastChanged >= slot.firstChanged) {
      const first = Math.floor(slot.firstChanged / rowFloats);
      const rows = Math.floor(slot.lastChanged / rowFloats) - first + 1;
      const gl = webgl.getContext() as WebGL2RenderingContext;
      const left = rows > 1 ? 0 : (slot.firstChanged % rowFloats) >> 2;
      const texels = rows > 1 ? this.width : ((slot.lastChanged % rowFloats) >> 2) - left + 1;
      const start = first * rowFloats + left * 4;
      bindTexture(webgl, gl.TEXTURE_2D, handle);
      unpackAsIs(webgl, gl);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, left, first, texels, rows, gl.RGBA, gl.FLOAT, this.data, start);
      unbindTexture(webgl);
      this.uploadedBytes = rows * texels * 16;
    }
    slot.firstChanged = Infinity;
    slot.lastChanged = -1;
  }

  private makeSlots(): void {
    this.slots = Array.from({ length: TURNS }, () => {
      const texture = new DataTexture(
        this.data,
        this.width,
        this.data.length / (this.width * 4),
        RGBAFormat,
        FloatType,
      );
      texture.magFilter = texture.minFilter = NearestFilter;
      texture.needsUpdate = true;
      return { texture, fresh: true, firstChanged: Infinity, lastChanged: -1 };
    });
  }
}
