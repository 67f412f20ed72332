/** Draws and times of one pass in the last frame. */
export interface PassInfo {
  readonly name: string;
  drawCalls: number;
  triangles: number;
  /** Time in the pass's JavaScript (ms). */
  cpuMs: number;
  /** GPU time (ms) a few frames ago; null in the first frames, without EXT_disjoint_timer_query_webgl2 or with `timing` off. */
  gpuMs: number | null;
}

/** Figures of the last frame. The same object and the same pass objects every frame: read, do not keep. */
export interface FarolInfo {
  /** Key of the technique that drew. */
  technique: string;
  /** Sentence that tells why 'auto' chose the technique. */
  reason: string;
  /** Sentence on how the page could have faster frames; null for none. From 2,000 single lights on it names LightField. */
  hint: string | null;
  /**
   * Names of the parts of Farol's code that the frame asked for and that are not loaded yet: being fetched, or to be
   * fetched again after a failure. A new array at each read.
   */
  readonly pending: readonly string[];
  readonly passes: PassInfo[];
  drawCalls: number;
  triangles: number;
  /** CPU time of the whole `render` call (ms). */
  cpuMs: number;
  /** Sum of the passes' GPU times (ms); null where they are not known. */
  gpuMs: number | null;
  /**
   * Number of lights of the scene, and of those kept for this frame; both include all lights that LightFields draw.
   */
  lights: { total: number; visible: number };
  /**
   * Shadow maps drawn in this frame and their texels; maps kept from earlier frames; of these, maps whose depth bounds
   * spare look-ups; bytes of the atlases.
   */
  shadows: { drawn: number; texels: number; kept: number; bounded: number; bytes: number };
  /** Programs alive in the WebGLRenderer. */
  programs: number;
  /** Bytes of render targets and light data that Farol holds on the GPU. */
  targetBytes: number;
  /** Bytes of light data uploaded in this frame. */
  uploadBytes: number;
}
