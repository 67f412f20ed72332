import type { BufferGeometry, Camera, Material, Object3D, WebGLRenderer } from 'three';
import type { GeometryGroup, RenderItemSort } from './RenderListItem';

/** Parts of three's WebGLRenderList that Farol uses. */
export interface RenderList {
  opaque: unknown[];
  transmissive: unknown[];
  push(
    object: Object3D,
    geometry: BufferGeometry,
    material: Material,
    groupOrder: number,
    z: number,
    group: GeometryGroup | null,
    /** Argument since three 0.186. */
    camera?: Camera,
  ): void;
  init(): void;
  /** @param reversed - whether to reverse the lists for reversed depth; only in three up to 0.185, whose `push` has no camera */
  sort(opaque: RenderItemSort | null, transparent: RenderItemSort | null, reversed?: boolean): void;
  finish(): void;
}

/** three's WebGLRenderLists. */
export interface RenderLists {
  /** @param depth - nesting depth of renders, as counted by three: one too high for each frame ended by an exception */
  get(scene: Object3D, depth: number): RenderList;
}

/** Render lists of a renderer; replaced when a lost context is restored. */
export function renderListsOf(webgl: WebGLRenderer): RenderLists {
  return webgl.renderLists as unknown as RenderLists;
}
