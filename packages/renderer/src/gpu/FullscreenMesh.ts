import { BufferGeometry, Mesh } from 'three';

/**
 * Geometry shared by all full-screen meshes of the page: three keeps a table for each geometry drawn without a scene for the
 * WebGLRenderer's lifetime, even after the geometry is disposed.
 */
const triangle = /* @__PURE__ */ makeTriangle();

/** One triangle that covers the viewport, with corners computed from gl_VertexID, so that nothing is uploaded. */
export class FullscreenMesh extends Mesh {
  constructor() {
    super(triangle);
    this.frustumCulled = false;
  }
}

function makeTriangle(): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setDrawRange(0, 3);
  return geometry;
}
