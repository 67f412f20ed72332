import { BufferGeometry, Mesh } from 'three';

/**
 * Of all full-screen meshes: three does not hear of the end of a geometry that is drawn without a scene, and keeps a table
 * for each one as long as the WebGLRenderer lives.
 */
const triangle = /* @__PURE__ */ makeTriangle();

/** One triangle that covers the viewport, its corners made from gl_VertexID, so that nothing is uploaded. */
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
