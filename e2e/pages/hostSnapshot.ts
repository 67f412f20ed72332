import * as THREE from 'three';

/** Things compared by what they hold, at most so many levels down. */
const DEPTH = 5;

function plain(value: unknown, depth: number, seen: Map<object, number>): unknown {
  if (typeof value === 'function') return `function ${value.name}`;
  if (typeof value !== 'object' || value === null) return typeof value === 'number' ? String(value) : value;
  const before = seen.get(value);
  if (before !== undefined) return `#${before}`;
  seen.set(value, seen.size);
  if (ArrayBuffer.isView(value)) return Array.from(value as Float32Array).join();
  if (depth === 0) return 'deep';
  if (Array.isArray(value)) return value.map((item) => plain(item, depth - 1, seen));
  return Object.fromEntries(
    Object.keys(value)
      .sort()
      // `_listeners` holds three's and Farol's own for disposal; `frame` is that in which three last moved bones
      .filter((key) => key !== '_listeners' && key !== 'frame')
      // `version` counts uploads of textures, which three makes in each frame for bones and batches
      .filter((key) => key !== 'version' || (value as THREE.Material).isMaterial === true)
      .map((key) => [key, plain((value as Record<string, unknown>)[key], depth - 1, seen)]),
  );
}

/** State of the device that the host may count on: three does not set it anew before each of its draws. */
function deviceState(gl: WebGL2RenderingContext): Record<string, unknown> {
  const names = [
    'COLOR_CLEAR_VALUE', 'DEPTH_CLEAR_VALUE', 'STENCIL_CLEAR_VALUE', 'COLOR_WRITEMASK', 'DEPTH_WRITEMASK', 'DEPTH_TEST',
    'SCISSOR_TEST', 'SCISSOR_BOX', 'VIEWPORT', 'FRAMEBUFFER_BINDING', 'READ_FRAMEBUFFER_BINDING', 'RENDERBUFFER_BINDING',
    'VERTEX_ARRAY_BINDING', 'POLYGON_OFFSET_FILL', 'PACK_ALIGNMENT', 'PIXEL_PACK_BUFFER_BINDING', 'RASTERIZER_DISCARD',
    'SAMPLE_ALPHA_TO_COVERAGE', 'SAMPLE_COVERAGE',
  ] as const; // prettier-ignore
  const state = Object.fromEntries(
    names.map((name) => {
      const value = gl.getParameter(gl[name]) as unknown;
      return [
        name,
        ArrayBuffer.isView(value)
          ? Array.from(value as Float32Array).join()
          : value instanceof Object
            ? 'an object'
            : value,
      ];
    }),
  );
  const attributes = Array.from({ length: gl.getParameter(gl.MAX_VERTEX_ATTRIBS) as number }, (_, i) =>
    (gl.getVertexAttrib(i, gl.CURRENT_VERTEX_ATTRIB) as Float32Array).join(),
  );
  return { ...state, attributes };
}

/** The own keys of a prototype and what they hold. */
const members = (prototype: object) =>
  Object.getOwnPropertyNames(prototype).map((name) => [
    name,
    String(Object.getOwnPropertyDescriptor(prototype, name)?.value),
  ]);

/** Everything of the host that a renderer could leave otherwise than it found it, by name, as text. */
export function hostSnapshot(
  webgl: THREE.WebGLRenderer,
  scene: THREE.Scene,
  camera: THREE.Camera,
): Record<string, string> {
  const text = (value: unknown) => JSON.stringify(plain(value, DEPTH, new Map()));
  const snapshot: Record<string, string> = {};
  scene.traverse((object) => {
    const { parent, children, ...own } = object;
    const named = `${object.type} ${object.name} ${object.id}`;
    snapshot[named] = text({ ...own, parent: parent?.id, children: children.map((child) => child.id) });
  });
  snapshot.camera = text(camera);
  snapshot.scene = text({
    background: scene.background,
    environment: scene.environment,
    fog: scene.fog,
    override: scene.overrideMaterial,
  });
  const {
    autoClear,
    autoClearColor,
    autoClearDepth,
    autoClearStencil,
    sortObjects,
    clippingPlanes,
    localClippingEnabled,
  } = webgl;
  const { toneMapping, toneMappingExposure, outputColorSpace } = webgl;
  snapshot.renderer = text({
    autoClear, autoClearColor, autoClearDepth, autoClearStencil, sortObjects, clippingPlanes, localClippingEnabled,
    toneMapping, toneMappingExposure, outputColorSpace,
    own: Object.keys(webgl).sort(),
    shadowMap: webgl.shadowMap,
    autoReset: webgl.info.autoReset,
    clearColor: webgl.getClearColor(new THREE.Color()),
    clearAlpha: webgl.getClearAlpha(),
    target: webgl.getRenderTarget() === null,
    viewport: webgl.getViewport(new THREE.Vector4()),
    scissor: webgl.getScissor(new THREE.Vector4()),
    scissorTest: webgl.getScissorTest(),
    pixelRatio: webgl.getPixelRatio(),
  }); // prettier-ignore
  snapshot.device = JSON.stringify(deviceState(webgl.getContext() as WebGL2RenderingContext));
  snapshot.chunks = JSON.stringify(THREE.ShaderChunk);
  snapshot.shaders = text(THREE.ShaderLib);
  snapshot.uniforms = text(THREE.UniformsLib);
  const prototypes = [
    THREE.Material,
    THREE.Object3D,
    THREE.Mesh,
    THREE.Light,
    THREE.Layers,
    THREE.BufferGeometry,
    THREE.Texture,
  ];
  snapshot.prototypes = JSON.stringify(prototypes.map(({ prototype }) => members(prototype)));
  return snapshot;
}
