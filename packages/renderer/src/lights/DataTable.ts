import { DataTexture, FloatType, NearestFilter, RGBAFormat, type WebGLRenderer } from 'three';

/**
 * A growable float texture that uploads only rows whose content changed since the last upload.
 * Without allocation while it does not grow.
 */
export class DataTable {
  texture: DataTexture;
  /** The texels, 4 floats each, row after row. */
  data: Float32Array<ArrayBuffer>;
  /** Bytes sent by the last `upload`. */
  uploadedBytes = 0;
  private firstChanged = Infinity;
  private lastChanged = -1;
  private fresh = true;

  /** @param width texels a row */
  constructor(readonly width: number) {
    this.data = new Float32Array(width * 4);
    this.texture = this.makeTexture();
  }

  /** Makes room for so many floats; content is lost when it grows. */
  reserve(floats: number): void {
    if (floats <= this.data.length) return;
    let rows = this.data.length / (this.width * 4);
    while (rows * this.width * 4 < floats) rows *= 2;
    this.data = new Float32Array(rows * this.width * 4);
    this.texture.dispose();
    this.texture = this.makeTexture();
    this.fresh = true;
  }

  /** Writes one texel at a float offset, and remembers whether it changed. */
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

  /** Says how many floats are in use, so that what lies behind is never uploaded. */
  used(floats: number): void {
    if (this.lastChanged >= floats) this.lastChanged = floats - 1;
  }

  /** Sends the rows that changed. Call inside a frame, before the texture is drawn with. */
  upload(webgl: WebGLRenderer): void {
    this.uploadedBytes = 0;
    const rowFloats = this.width * 4;
    const gone = (webgl.properties.get(this.texture) as { __webglTexture?: WebGLTexture }).__webglTexture === undefined;
    if (this.fresh || gone) {
      webgl.initTexture(this.texture);
      this.fresh = false;
      this.uploadedBytes = this.data.byteLength;
    } else if (this.lastChanged >= this.firstChanged) {
      const first = Math.floor(this.firstChanged / rowFloats);
      const rows = Math.floor(this.lastChanged / rowFloats) - first + 1;
      const gl = webgl.getContext() as WebGL2RenderingContext;
      const { state } = webgl;
      const properties = webgl.properties.get(this.texture) as { __webglTexture: WebGLTexture };
      state.bindTexture(gl.TEXTURE_2D, properties.__webglTexture);
      state.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
      state.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
      state.pixelStorei(gl.UNPACK_ALIGNMENT, 4);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, first, this.width, rows, gl.RGBA, gl.FLOAT, this.data, first * rowFloats);
      state.unbindTexture();
      this.uploadedBytes = rows * rowFloats * 4;
    }
    this.firstChanged = Infinity;
    this.lastChanged = -1;
  }

  /** Size of the texture in bytes. */
  get bytes(): number {
    return this.data.byteLength;
  }

  dispose(): void {
    this.texture.dispose();
  }

  private makeTexture(): DataTexture {
    const texture = new DataTexture(this.data, this.width, this.data.length / (this.width * 4), RGBAFormat, FloatType);
    texture.magFilter = texture.minFilter = NearestFilter;
    texture.needsUpdate = true;
    return texture;
  }
}
