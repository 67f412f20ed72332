/** Method by which missing normals of a mesh are computed. */
export type NormalsWay = 'faces' | 'crease';

/** One of the two pictures of figure 4.3: the atrium with normals removed and computed anew. */
export interface NormalsPicture {
  /** 8-bit sRGB, top row first. */
  readonly picture: ImageData;
  /** Share, 0 to 1, of the triangles' corners whose normal deviates from the triangle's by more than `creaseAngle`. */
  readonly leaning: number;
}

/** Angle between triangles from which on they meet at a sharp edge, and deviation from which a normal leans (radians). */
export const creaseAngle = Math.PI / 6;
