/**
 * @typedef {object} FrameCounts what a piece of work asked of WebGL
 * @property {number} draws draw calls; one of WEBGL_multi_draw counts once, however many runs it draws
 * @property {number} triangles drawn, instances included
 * @property {number} programs linked
 * @property {number} uploadBytes of textures and buffers sent to the device; uniforms are not counted
 *
 * @typedef {object} Counters
 * @property {number} programs linked since the page opened
 * @property {(gl: WebGL2RenderingContext) => number} programsOf linked by a context since the page opened
 * @property {(work: () => void) => FrameCounts} count counts while `work` runs; otherwise nothing is slowed
 */

/**
 * Puts `window.farolCounters`, a {@link Counters}, into a page. To be run there before its own scripts
 * (`page.addInitScript(installCounters)`): it counts on WebGL's prototype, so it sees every renderer's work alike.
 */
export function installCounters() {
  const prototype = WebGL2RenderingContext.prototype;
  const { linkProgram, getExtension } = prototype;
  /** Prototype of the extension WEBGL_multi_draw, which has no name of its own; null until a context asks for it. */
  let multiDraw = /** @type {object | null} */ (null);
  /** @type {WeakMap<WebGL2RenderingContext, number>} */
  const linked = new WeakMap();
  const counts = { draws: 0, triangles: 0, programs: 0, uploadBytes: 0 };
  /** @type {Counters} */
  const counters = {
    programs: 0,
    programsOf: (gl) => linked.get(gl) ?? 0,
    count(work) {
      Object.assign(counts, { draws: 0, triangles: 0, uploadBytes: 0 });
      const before = counters.programs;
      const restore = watch(prototype, rules);
      const restoreMultiDraw = multiDraw && watch(multiDraw, multiDrawRules);
      try {
        work();
      } finally {
        restore();
        restoreMultiDraw?.();
      }
      return { ...counts, programs: counters.programs - before };
    },
  };
  prototype.getExtension = /** @type {any} */ (
    /** @this {WebGL2RenderingContext} @param {string} name */ function (name) {
      const extension = Reflect.apply(getExtension, this, [name]);
      if (name === 'WEBGL_multi_draw' && extension) multiDraw = Object.getPrototypeOf(extension);
      return extension;
    }
  );
  prototype.linkProgram = function (program) {
    counters.programs++;
    linked.set(this, counters.programsOf(this) + 1);
    return linkProgram.call(this, program);
  };

  /**
   * Makes methods of an object call a rule with their arguments before they do their work.
   *
   * @param {object} object
   * @param {Record<string, (args: unknown[]) => void>} rules
   * @returns {() => void} what ends it
   */
  function watch(object, rules) {
    const saved = Object.keys(rules).map((name) => [name, Reflect.get(object, name)]);
    for (const [name, method] of saved) {
      Reflect.set(
        object,
        name,
        /** @this {unknown} @param {unknown[]} args */ function (...args) {
          rules[name](args);
          return method.apply(this, args);
        },
      );
    }
    return () => {
      for (const [name, method] of saved) Reflect.set(object, name, method);
    };
  }

  /** @param {unknown} mode @param {unknown} list - vertex counts @param {unknown} from @param {unknown} length */
  function drawMany(mode, list, from, length) {
    const runs = /** @type {ArrayLike<number>} */ (list);
    const before = counts.draws;
    for (let i = 0; i < Number(length); i++) draw(mode, runs[Number(from) + i], 1);
    counts.draws = before + 1;
  }

  /** @param {unknown} mode @param {unknown} vertices @param {unknown} instances */
  function draw(mode, vertices, instances) {
    const each = mode === 4 ? Number(vertices) / 3 : mode === 5 || mode === 6 ? Number(vertices) - 2 : 0;
    counts.draws++;
    counts.triangles += Math.max(0, each) * Number(instances);
  }

  /** Texel size in bytes, by WebGL's numbers of format and type. @param {unknown} format @param {unknown} type */
  function texelBytes(format, type) {
    /** @type {Record<number, number>} */
    const channels = { 0x1903: 1, 0x8d94: 1, 0x1902: 1, 0x1906: 1, 0x1909: 1, 0x8227: 2, 0x8228: 2, 0x190a: 2 };
    Object.assign(channels, { 0x1907: 3, 0x8d98: 3, 0x1908: 4, 0x8d99: 4 });
    /** @type {Record<number, number>} */
    const sizes = { 0x1400: 1, 0x1401: 1, 0x1402: 2, 0x1403: 2, 0x140b: 2, 0x1404: 4, 0x1405: 4, 0x1406: 4 };
    const size = sizes[Number(type)];
    // the packed types are a whole texel of 2 or of 4 bytes
    const packed = [0x8033, 0x8034, 0x8363].includes(Number(type)) ? 2 : 4;
    return size === undefined ? packed : size * (channels[Number(format)] ?? 4);
  }

  /**
   * @param {unknown[]} args - of texImage or texSubImage
   * @param {number} sized - least count of arguments with which width and height are among them
   * @param {number} extent - index of the width
   * @param {number} dimensions - 2 or 3
   * @param {number} format - index of the format in the sized form
   */
  function texture(args, sized, extent, dimensions, format) {
    if (args.length < sized) {
      const source = /** @type {{ width?: number, height?: number } | null} */ (args[args.length - 1]);
      counts.uploadBytes += (source?.width ?? 0) * (source?.height ?? 0) * 4;
      return;
    }
    if (args[format + 2] === null) return;
    const texels = args
      .slice(extent, extent + dimensions)
      .reduce((/** @type {number} */ all, side) => all * Number(side), 1);
    counts.uploadBytes += texels * texelBytes(args[format], args[format + 1]);
  }

  /** @param {unknown} data @param {unknown} [length] - in elements */
  function bytesOf(data, length) {
    if (ArrayBuffer.isView(data)) {
      const element = 'BYTES_PER_ELEMENT' in data ? Number(data.BYTES_PER_ELEMENT) : 1;
      return Number(length) > 0 ? Number(length) * element : data.byteLength;
    }
    return data instanceof ArrayBuffer ? data.byteLength : 0;
  }

  /** @type {Record<string, (args: unknown[]) => void>} */
  const rules = {
    drawArrays: ([mode, , vertices]) => draw(mode, vertices, 1),
    drawElements: ([mode, vertices]) => draw(mode, vertices, 1),
    drawRangeElements: ([mode, , , vertices]) => draw(mode, vertices, 1),
    drawArraysInstanced: ([mode, , vertices, instances]) => draw(mode, vertices, instances),
    drawElementsInstanced: ([mode, vertices, , , instances]) => draw(mode, vertices, instances),
    texImage2D: (args) => texture(args, 9, 3, 2, 6),
    texSubImage2D: (args) => texture(args, 9, 4, 2, 6),
    texImage3D: (args) => texture(args, 10, 3, 3, 7),
    texSubImage3D: (args) => texture(args, 11, 5, 3, 8),
    bufferData: ([, data, , , length]) => void (counts.uploadBytes += bytesOf(data, length)),
    bufferSubData: ([, , data, , length]) => void (counts.uploadBytes += bytesOf(data, length)),
  };
  /** @type {Record<string, (args: unknown[]) => void>} */
  const multiDrawRules = {
    multiDrawArraysWEBGL: ([mode, , , runs, from, length]) => drawMany(mode, runs, from, length),
    multiDrawElementsWEBGL: ([mode, runs, from, , , , length]) => drawMany(mode, runs, from, length),
  };
  Object.assign(window, { farolCounters: counters });
}
