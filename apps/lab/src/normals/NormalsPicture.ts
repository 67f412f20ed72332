/** How the normals of a mesh that has none are computed. */
export type NormalsWay = 'faces' | 'crease';

/** One of the two pictures of figure 4.3: the atrium, its normals taken off and computed again. */
export interface NormalsPicture {
  /** 8-bit sRGB, top row first. */
  readonly picture: ImageData;
  /** Share of the triangles' corners whose normal leans from the triangle by more than `creaseAngle`: 0 to 1. */
  readonly leaning: number;
}

/** Angle between triangles from which on they meet at an edge (radians); also where a normal counts as leaning. */
export const creaseAngle = Math.PI / 6;
