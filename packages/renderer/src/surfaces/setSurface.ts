import type { IUniform, Material } from 'three';
import { ownSurfacesOf, surfacesOf as wornBy } from '../materials/surfacesOf';
import { MaterialSurfaces } from './MaterialSurfaces';
import type { Surface, SurfaceValue, SurfaceValues } from './Surface';

/** The values of a surface's declared uniforms on one material, by name: `uniforms.height.value = 0.4`. */
export type SurfaceUniforms = Readonly<Record<string, IUniform<SurfaceValue>>>;

/** One of the surfaces (GLSL hooks) of a material, with its values. */
export interface WornSurface {
  readonly surface: Surface;
  readonly uniforms: SurfaceUniforms;
}

type AnyMaterial = Material & Record<`is${string}Material`, boolean | undefined>;

const WEARERS = ['Standard', 'Lambert', 'Phong', 'Toon', 'Basic', 'Matcap'] as const;

/** Whether a material can use surfaces: three's own mesh materials but for depths, distances and normals. */
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
 * Gives a material a surface in place of all that it wore: whatever draws it by Farol draws it so, in every technique,
 * its G-buffer, depth and motion, its shadows included. Nothing of the material is changed: stock three draws it
 * without the surface. Where vertices move farther than their geometry's bounding sphere reaches, set `frustumCulled`
 * of the objects to false, or give them a `boundingSphere` that is larger by `surfaceReach(material)`.
 * @param surface - the surface; null for none
 * @param values - values of the surface's uniforms, in place of their defaults; vectors and linear colours may be lists
 * of numbers
 * @returns the values, which may be changed at any time
 * @throws Error for a material that is none of three's mesh materials, or a value of a uniform that is not declared
 */
export function setSurface(material: Material, surface: Surface | null, values: SurfaceValues = {}): SurfaceUniforms {
  return surfacesOf(material).set(surface === null ? [] : [surface], surface, values);
}

/**
 * Adds a surface to a material, applied after its other surfaces; else as `setSurface`.
 * @returns the values of the added one
 */
export function addSurface(material: Material, surface: Surface, values: SurfaceValues = {}): SurfaceUniforms {
  const surfaces = surfacesOf(material);
  const others = surfaces.list.map((worn) => worn.surface).filter((other) => other !== surface);
  return surfaces.set([...others, surface], surface, values);
}

/**
 * Gives a material all surfaces of another one, by the values of that one, and one more surface of its own after them;
 * a surface that both wear is worn once, by the own values. For a material that is a copy of the other one, for some of
 * its objects. To be called again when the other one wears other surfaces.
 * @returns the values of the own one
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
