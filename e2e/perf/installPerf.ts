import type { Counters, FrameCounts } from '@farol/tools/benchCounters';
import type { FarolRenderer, TechniqueName } from '@farol/renderer';
import type { LightField } from '@farol/renderer/light-field';
import type { Camera, Light, Mesh, Scene } from 'three';

export interface WorldOptions {
  /** Boxes in a square grid that faces the camera; default 9. */
  objects?: number;
  /** Point lights just before the boxes, each within reach of one of them; default 10. */
  lights?: number;
  /** Number of the lights that are spot lights; default 0. */
  spots?: number;
  /** Point lights of one LightField, at the same places; default 0: there is no field. */
  fieldLights?: number;
  /** Directional lights besides; default 1. */
  directional?: number;
  /** Pixels; default 64 × 48. */
  width?: number;
  height?: number;
}

/** A scene of known counts, and a FarolRenderer of its own that draws it to the canvas. */
export interface World {
  readonly farol: FarolRenderer;
  readonly scene: Scene;
  readonly camera: Camera;
  readonly objects: Mesh[];
  /** The lights with a range. */
  readonly lights: Light[];
  /** The LightField, if one was asked for. */
  readonly field: LightField | null;
  draw(): void;
  count(): FrameCounts;
  setSize(width: number, height: number): void;
  dispose(): void;
}

/** `window.perf`: what the performance tests do in the tests' own page. */
export interface Perf {
  readonly techniques: readonly TechniqueName[];
  world(technique: TechniqueName, options?: WorldOptions): World;
  /** Bytes of all textures and renderbuffers that are alive, by what WebGL was asked for. */
  textureBytes(): number;
  /** Makes every draw call do nothing from here on: only JavaScript is left to measure. */
  drawNothing(): void;
}

declare global {
  interface Window {
    farolCounters: Counters;
    perf: Perf;
  }
}

/** Puts `window.perf` into the tests' own page; to be run there before its scripts, in one piece. */
export function installPerf(): void {
  const prototype = WebGL2RenderingContext.prototype;
  const bytes = new Map<WebGLTexture | WebGLRenderbuffer, Map<string, number>>();
  const texels: Record<number, number> = {
    ...{ 0x8229: 1, 0x822b: 2, 0x8051: 4, 0x8058: 4, 0x8c43: 4, 0x1908: 4, 0x8059: 4, 0x8c3a: 4, 0x8c3d: 4 },
    ...{ 0x822d: 2, 0x822f: 4, 0x881a: 8, 0x822e: 4, 0x8230: 8, 0x8814: 16 },
    ...{ 0x8232: 1, 0x8238: 2, 0x8d7c: 4, 0x8234: 2, 0x823a: 4, 0x8d76: 8, 0x8236: 4, 0x823c: 8, 0x8d70: 16 },
    ...{ 0x81a5: 2, 0x81a6: 4, 0x8cac: 4, 0x88f0: 4, 0x8cad: 8 },
  };

  function allocated(gl: WebGL2RenderingContext, target: number, part: string, format: number, count: number): void {
    const binding: Record<number, number> = { 0x0de1: 0x8069, 0x806f: 0x806a, 0x8c1a: 0x8c1d, 0x8d41: 0x8ca7 };
    const bound = gl.getParameter(binding[target] ?? 0x8514) as WebGLTexture | null; // else a side of a cube
    if (!(format in texels)) throw new Error(`textureBytes: add the format 0x${format.toString(16)} to its table`);
    if (!bound) return;
    const parts = bytes.get(bound) ?? new Map<string, number>();
    bytes.set(bound, parts.set(part, texels[format] * count));
  }
  const { texImage2D, texImage3D, texStorage2D, texStorage3D, renderbufferStorage, renderbufferStorageMultisample } =
    prototype;
  const { deleteTexture, deleteRenderbuffer } = prototype;
  const pass = (method: unknown, self: unknown, args: unknown[]) => (method as () => void).apply(self, args as []);
  const levels = (count: number, size: number) => {
    let sum = 0;
    for (let level = 0; level < count; level++) sum += Math.max(1, size / 4 ** level);
    return sum;
  };
  Object.assign(prototype, {
    texImage2D(this: WebGL2RenderingContext, ...args: number[]) {
      pass(texImage2D, this, args);
      const [target, level, format, width, height] = args;
      if (args.length >= 9) allocated(this, target, `${target} ${level}`, format, width * height);
    },
    texImage3D(this: WebGL2RenderingContext, ...args: number[]) {
      pass(texImage3D, this, args);
      allocated(this, args[0], String(args[1]), args[2], args[3] * args[4] * args[5]);
    },
    texStorage2D(this: WebGL2RenderingContext, ...args: number[]) {
      pass(texStorage2D, this, args);
      allocated(this, args[0], 'all', args[2], levels(args[1], args[3] * args[4]));
    },
    texStorage3D(this: WebGL2RenderingContext, ...args: number[]) {
      pass(texStorage3D, this, args);
      allocated(this, args[0], 'all', args[2], levels(args[1], args[3] * args[4] * args[5]));
    },
    renderbufferStorage(this: WebGL2RenderingContext, ...args: number[]) {
      pass(renderbufferStorage, this, args);
      allocated(this, args[0], 'all', args[1], args[2] * args[3]);
    },
    renderbufferStorageMultisample(this: WebGL2RenderingContext, ...args: number[]) {
      pass(renderbufferStorageMultisample, this, args);
      allocated(this, args[0], 'all', args[2], Math.max(1, args[1]) * args[3] * args[4]);
    },
    deleteTexture(this: WebGL2RenderingContext, texture: WebGLTexture | null) {
      if (texture) bytes.delete(texture);
      deleteTexture.call(this, texture);
    },
    deleteRenderbuffer(this: WebGL2RenderingContext, renderbuffer: WebGLRenderbuffer | null) {
      if (renderbuffer) bytes.delete(renderbuffer);
      deleteRenderbuffer.call(this, renderbuffer);
    },
  });

  let shared: InstanceType<typeof window.testPage.three.WebGLRenderer> | null = null;

  window.perf = {
    get techniques() {
      return Object.keys(window.testPage.farol.techniques) as TechniqueName[];
    },

    world(technique, options = {}) {
      const {
        objects = 9,
        lights = 10,
        spots = 0,
        fieldLights = 0,
        directional = 1,
        width = 64,
        height = 48,
      } = options;
      const { farol: package_, lightFields, three } = window.testPage;
      const webgl = (shared ??= new three.WebGLRenderer({ antialias: false }));
      webgl.setSize(width, height, false);
      const side = Math.ceil(Math.sqrt(objects));
      const scene = new three.Scene();
      const camera = new three.OrthographicCamera(-side, side, side, -side, 0.1, 20);
      camera.position.z = 10;
      const geometry = new three.BoxGeometry();
      const material = new three.MeshStandardMaterial();
      const at = (i: number) => [2 * (i % side) + 1 - side, 2 * Math.floor(i / side) + 1 - side] as const;
      const meshes = Array.from({ length: objects }, (_, i) => {
        const mesh = new three.Mesh(geometry, material);
        mesh.position.set(...at(i), 0);
        scene.add(mesh);
        return mesh;
      });
      const found = Array.from({ length: lights }, (_, i) => {
        const light = i < spots ? new three.SpotLight(0xffffff, 1, 0.8, 0.6) : new three.PointLight(0xffffff, 1, 0.8);
        // a box reaches 0.87 from its middle, its neighbours' middles are 2 away: 1.0 before one box reaches that one alone
        light.position.set(...at(i % objects), 1 + (0.1 * i) / lights);
        if (light instanceof three.SpotLight) {
          light.target.position.set(light.position.x, light.position.y, 0);
          scene.add(light.target);
        }
        scene.add(light);
        return light;
      });
      const field = fieldLights > 0 ? new lightFields.LightField(fieldLights) : null;
      if (field !== null) scene.add(field);
      for (let i = 0; i < fieldLights; i++)
        field!.setPoint(i, ...at(i % objects), 1 + (0.1 * i) / fieldLights, 0.8, 1, 1, 1);
      for (let i = 0; i < directional; i++) scene.add(new three.DirectionalLight(0xffffff, 0.1));
      const farol = new package_.FarolRenderer(webgl, { technique });
      const draw = () => farol.render(scene, camera);
      return {
        ...{ farol, scene, camera, objects: meshes, lights: found, field, draw },
        count: () => window.farolCounters.count(draw),
        setSize: (width, height) => webgl.setSize(width, height, false),
        dispose() {
          farol.dispose();
          field?.dispose();
          geometry.dispose();
          material.dispose();
        },
      };
    },

    textureBytes() {
      let sum = 0;
      for (const parts of bytes.values()) for (const part of parts.values()) sum += part;
      return sum;
    },

    drawNothing() {
      const nothing = () => {};
      Object.assign(prototype, { drawArrays: nothing, drawElements: nothing });
      Object.assign(prototype, { drawArraysInstanced: nothing, drawElementsInstanced: nothing });
    },
  };
}
