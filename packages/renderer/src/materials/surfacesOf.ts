import type { Material, WebGLRenderer } from 'three';
import type { MicroShaderRegistry } from '../microshaders';
import type { TwinShader } from './TwinKind';

/** Surfaces (GLSL hooks) that one material uses. Made only by `setSurface` of the entry `surfaces`. */
export interface WornSurfaces {
  /** Whether a surface of the material displaces vertices. */
  readonly displaces: boolean;
  readonly discards: boolean;
  /** Number that changes with the list of surfaces and with their texts. */
  version(registry: MicroShaderRegistry): number;
  /** Part of a program's cache key; '' for no surfaces. */
  key(registry: MicroShaderRegistry): string;
  /** Adds the surfaces to a shader of three's, before any other patch. */
  rewrite(shader: TwinShader, registry: MicroShaderRegistry, webgl: WebGLRenderer): void;
  /** Number that changes when a GLSL text, uniform value or time changes the colours of pixels. */
  colourVersion(): number;
  shapeVersion(): number;
  /** Writes the animation time (s) of each surface to `times`. */
  copyTimes(times: number[]): void;
  /** Greatest displacement of vertices (m, in the object's own space); Infinity if a surface does not declare it. */
  reach(): number;
  /** Sets the animation time (s) that each surface had in the last frame, for motion vectors. */
  setTimesBefore(times: readonly number[]): void;
}

const worn = new WeakMap<Material, WornSurfaces>();
let hasSurfaces = false;

/** Surfaces of a host's material, inherited from a material that is its prototype. */
export function surfacesOf(material: Material | null): WornSurfaces | undefined {
  return hasSurfaces && material ? (worn.get(material) ?? inherited(material)) : undefined;
}

function inherited(material: Material): WornSurfaces | undefined {
  const above = Object.getPrototypeOf(material) as Material;
  // material classes of three, at the end of the prototype chain, have no id
  return Object.hasOwn(above, 'id') ? surfacesOf(above) : undefined;
}

/** Surfaces of a material, without those of a prototype. */
export const ownSurfacesOf = (material: Material): WornSurfaces | undefined => worn.get(material);

/** Sets the surfaces of a material. Called only by the entry `surfaces`. */
export function wearSurfaces(material: Material, surfaces: WornSurfaces): void {
  hasSurfaces = true;
  worn.set(material, surfaces);
}
