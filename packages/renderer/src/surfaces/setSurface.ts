import type { IUniform, Material } from 'three';
import { ownSurfacesOf, surfacesOf as wornBy } from '../materials/surfacesOf';
import { MaterialSurfaces } from './MaterialSurfaces';
import type { Surface, SurfaceValue, SurfaceValues } from './Surface';

/** Values of a surface's uniforms on one material, by name: `uniforms.height.value = 0.4`. */
export type SurfaceUniforms = Readonly<Record<string, IUniform<SurfaceValue>>>;

/** One of the surfaces (GLSL hooks) of a material, with its values. */
export interface WornSurface {
  readonly surface: Surface;
  readonly uniforms: SurfaceUniforms;
}

type AnyMaterial = Material & Record<`is${string}Material`, boolean | undefined>;

const WEARERS = ['Standard', 'Lambert', 'Phong', 'Toon', 'Basic', 'Matcap'] as const;

/** Whether a material can use surfaces: three's own mesh materials, except those for depths, distances and normals. */
export function canWearSurface(material: Material): boolean {
  return WEARERS.some((name) => (material as AnyMaterial)[`isMesh${name}Material`] === true);
}

function surfacesOf(material: Material): MaterialSurfaces {
  const known = ownSurfacesOf(material);
  if (known instanceof MaterialSurfaces) return known;
  if (!canWearSurface(material))
    throw new Error(
      `Material "${material.name || material.type}" cannot have a surface: give its object a MeshStandardMaterial, MeshPhysicalMaterial, MeshLambertMaterial, MeshPhongMaterial, MeshToonMaterial, MeshBasicMaterial or MeshMatcapMaterial.`,
    );
  return new MaterialSurfaces(material);
}

/**
 * Sets the only surface of a material, which Farol then applies in every technique: to pictures, G-buffers, depth, motion and
 * shadows. The material itself is not changed: stock three draws it without the surface. If vertices leave their geometry's
 * bounding sphere, set `frustumCulled` of the objects to false, or give them a `boundingSphere` that is larger by
 * `surfaceReach(material)`.
 * @param surface - the surface; null for none
 * @param values - values of the surface's uniforms, in place of defaults; vectors and linear colours may be arrays of numbers
 * @returns the values, which may be changed at any time
 * @throws Error for a material other than three's mesh materials, or a value for an undeclared uniform
 */
export function setSurface(material: Material, surface: Surface | null, values: SurfaceValues = {}): SurfaceUniforms {
  return surfacesOf(material).set(surface === null ? [] : [surface], surface, values);
}

/**
 * Adds a surface to a material, applied after its other surfaces; otherwise like `setSurface`.
 * @returns the values of the added surface
 */
export function addSurface(material: Material, surface: Surface, values: SurfaceValues = {}): SurfaceUniforms {
  const surfaces = surfacesOf(material);
  const others = surfaces.list.map((worn) => worn.surface).filter((other) => other !== surface);
  return surfaces.set([...others, surface], surface, values);
}

/**
 * Gives a material all surfaces of another one, sharing their values, followed by one more surface; a surface in both is applied
 * once, with the material's own values. For a copy of the other material that some objects use. Call again when the other
 * material's surfaces change.
 * @returns the values of the added surface
 */
export function layerSurface(
  material: Material,
  below: Material,
  surface: Surface,
  values: SurfaceValues = {},
): SurfaceUniforms {
  const others = wornBy(below);
  return surfacesOf(material).layer(others instanceof MaterialSurfaces ? others : null, surface, values);
}

/**
 * Greatest displacement of vertices by a material's surfaces (m, in the object's own space): 0 without displacement,
 * Infinity if a surface that displaces does not declare its reach (`// reach: 0.5 * height`).
 */
export function surfaceReach(material: Material): number {
  return wornBy(material)?.reach() ?? 0;
}

/** Surfaces of a material, in the order in which they are applied. */
export function getSurfaces(material: Material): readonly WornSurface[] {
  const known = wornBy(material);
  return known instanceof MaterialSurfaces ? known.list : [];
}
