/** Contents of one frame of a scene. */
export interface SceneCounts {
  /** Opaque objects, one material each. */
  objects: number;
  /** Pairs of a light and an object that it may reach, a light without a range reaching all. */
  pairs: number;
}

/** Most draws, passes, garbage and shading of a technique. */
export interface Budget {
  /** Draw calls of a frame. */
  draws(scene: SceneCounts): number;
  /** Passes of a frame, those that draw nothing included. */
  passes: number;
  /** Bytes of targets for each pixel, light lists included, with 1,000 lights. */
  bytesPerPixel: number;
  /** Bytes of light lists sent when one of 1,000 lights moves. */
  listsOfOne: number;
  /** Bytes of light lists sent when all of 1,000 lights move. */
  listsOfAll: number;
  /** Bytes of JavaScript memory that a frame allocates for each light. */
  garbageOfLight: number;
  /** Garbage for each object (bytes a frame). */
  garbageOfObject: number;
  /** How often a pixel is shaded when an object covers it, and how often a light that reaches it is evaluated there. */
  shadings: number;
  lightings: number;
  /** Depth is known before anything is shaded: what is hidden is not shaded, whatever the order. */
  depthFirst: boolean;
}

/** Global lights, spheres, cones. */
const VOLUMES = 3;
/** Coarse lists, lists, summary. */
const LISTS = 3;
/** Depths of blocks and of tiles. */
const DEPTHS = 2;
const OUTPUT = 1;
/** Passes: opaque, transmissive, transparent. */
const TAIL = 3;
/** RGBA16F accumulation, RG16F normal, RGBA8 albedo, RGBA8 material, 32-bit depth. */
const GBUFFER = 24;
/** A bit a light and tile of 16 × 16 pixels, with room to grow by a quarter, and what is a row of 2,048 texels at least. */
const LISTS_BYTES = 2;

/**
 * Budget of a technique that has no row below: it draws an object twice at most and nothing a light, and sends lists made on the
 * CPU. Its garbage is numbers that V8 puts on the heap to pass them to a function, 12 bytes each, and arrays of lights that
 * are emptied and filled again, 14 bytes a light each; three itself takes 24 bytes an object
 * and some more a draw.
 */
const ordinary: Budget = {
  draws: ({ objects }) => 2 * objects + 12,
  passes: 10,
  bytesPerPixel: 64,
  listsOfOne: 65_536,
  listsOfAll: 262_144,
  garbageOfLight: 260,
  garbageOfObject: 120,
  shadings: 1,
  lightings: 1,
  depthFirst: false,
};

/** The colour behind everything, in place of a clear. */
const BACKGROUND = 1;

/** Lists made on the GPU, or none. */
const withoutCpuLists = { listsOfOne: 0, listsOfAll: 0, garbageOfLight: 110, garbageOfObject: 70 };

const budgets: Record<string, Partial<Budget>> = {
  // base, a draw for each pair, output; 32-bit float sum, depth and stencil
  forward: {
    ...withoutCpuLists,
    draws: ({ objects, pairs }) => objects + pairs + OUTPUT,
    passes: 2 + TAIL,
    bytesPerPixel: 24,
    garbageOfLight: 210,
  },
  'forward-single-pass': {
    ...withoutCpuLists,
    draws: ({ objects }) => objects + BACKGROUND,
    passes: TAIL,
    bytesPerPixel: 0,
  },
  // G-buffer; half-float light and a copy of depth
  deferred: {
    ...withoutCpuLists,
    draws: ({ objects }) => objects + VOLUMES + OUTPUT,
    passes: 3 + TAIL,
    bytesPerPixel: GBUFFER + 12,
  },
  'tiled-deferred': {
    ...withoutCpuLists,
    draws: ({ objects }) => objects + DEPTHS + LISTS + OUTPUT,
    passes: 3 + TAIL,
    bytesPerPixel: GBUFFER + LISTS_BYTES,
  },
  'tiled-forward': {
    ...withoutCpuLists,
    draws: ({ objects }) => objects + LISTS + BACKGROUND,
    passes: 1 + TAIL,
    bytesPerPixel: LISTS_BYTES,
  },
  // the G-buffer and the materials draw each object; light buffers of diffuse and specular in half floats, with depth
  'light-prepass': {
    ...withoutCpuLists,
    draws: ({ objects }) => 2 * objects + VOLUMES + OUTPUT + BACKGROUND,
    bytesPerPixel: 40,
    garbageOfObject: 120,
    shadings: 2,
  },
  // the same at half of the width and height but for the materials
  inferred: {
    ...withoutCpuLists,
    draws: ({ objects }) => 2 * objects + VOLUMES + OUTPUT + 1 + BACKGROUND,
    bytesPerPixel: 10,
    garbageOfObject: 120,
    shadings: 1.25,
    lightings: 0.25,
  },
  'forward-plus': {
    ...withoutCpuLists,
    // each object's depth into a target of 8 bytes a pixel, on to the canvas, then each object
    draws: ({ objects }) => 2 * objects + DEPTHS + LISTS + OUTPUT + BACKGROUND,
    passes: 2 + TAIL,
    bytesPerPixel: 8 + LISTS_BYTES,
    garbageOfObject: 120,
    depthFirst: true,
  },
  // lists made on the CPU
  'clustered-deferred': {
    draws: ({ objects }) => objects + OUTPUT,
    passes: 3 + TAIL,
    bytesPerPixel: GBUFFER + LISTS_BYTES,
  },
  'clustered-forward': { draws: ({ objects }) => objects + BACKGROUND, passes: 1 + TAIL, bytesPerPixel: LISTS_BYTES },
};

/** Budget of a technique; a new one has the ordinary budget until it gets a row. */
export const budgetOf = (technique: string): Budget => ({ ...ordinary, ...budgets[technique] });

/** Techniques that draw an object again for each light that reaches it; all others draw as often under any lights. */
export const drawsByLight = new Set(['forward']);
