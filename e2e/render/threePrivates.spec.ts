import { expect, test } from '../support/test';

/** Private parts of three that packages/renderer/src/three relies on: an upgrade that removes one is named here. */
test('three has what Farol uses of its private parts', async ({ benchPage: page }) => {
  const found = await page.evaluate(() => {
    const { three: THREE } = window.testPage;
    // as three's code has them, untyped
    // oxlint-disable-next-line typescript/no-explicit-any -- what three keeps private has no types
    const webgl = new THREE.WebGLRenderer({ canvas: document.createElement('canvas') }) as any;
    const target = new THREE.WebGLRenderTarget(2, 2, { samples: 4 });
    const scene = new THREE.Scene();
    const material = new THREE.MeshBasicMaterial({ map: target.texture.clone() });
    // oxlint-disable-next-line typescript/no-explicit-any -- what three keeps private has no types
    const batch = new THREE.BatchedMesh(1, 3, 3, material) as any;
    scene.add(new THREE.Mesh(new THREE.PlaneGeometry(), material));
    const camera = new THREE.PerspectiveCamera();
    camera.position.z = 2;
    webgl.setRenderTarget(target);
    const { renderLists } = webgl;
    webgl.render(scene, camera);
    const list = renderLists.get(scene, 0);
    const kept = webgl.properties.get(target);
    const [program] = webgl.info.programs;
    const type = (value: unknown): string => (value === null ? 'null' : typeof value);
    const types = {
      'state.viewport': type(webgl.state.viewport),
      'state.scissor': type(webgl.state.scissor),
      'state.setScissorTest': type(webgl.state.setScissorTest),
      'state.bindFramebuffer': type(webgl.state.bindFramebuffer),
      'state.bindTexture': type(webgl.state.bindTexture),
      'state.unbindTexture': type(webgl.state.unbindTexture),
      'state.useProgram': type(webgl.state.useProgram),
      'state.buffers.color.setMask': type(webgl.state.buffers.color.setMask),
      'state.buffers.depth.setMask': type(webgl.state.buffers.depth.setMask),
      'state.buffers.depth.setTest': type(webgl.state.buffers.depth.setTest),
      'state.buffers.stencil.setMask': type(webgl.state.buffers.stencil.setMask),
      renderBufferDirect: type(webgl.renderBufferDirect),
      'renderLists.get': type(renderLists.get),
      'list.init': type(list.init),
      'list.push': type(list.push),
      'list.sort': type(list.sort),
      'list.finish': type(list.finish),
      'program.getUniforms': type(program.getUniforms),
      'program.getAttributes': type(program.getAttributes),
      'program.isReady': type(program.isReady),
      'camera.updateProjectionMatrix': type(camera.updateProjectionMatrix),
    };
    const values = {
      'depth is reversed': webgl.state.buffers.depth.getReversed(),
      'camera.reversedDepth': camera.reversedDepth,
      'list.opaque': list.opaque.length,
      'list.transmissive': list.transmissive.length,
      'target framebuffer': kept.__webglFramebuffer instanceof WebGLFramebuffer,
      'target multisampled framebuffer': kept.__webglMultisampledFramebuffer instanceof WebGLFramebuffer,
      'texture handle': webgl.properties.get(target.texture).__webglTexture instanceof WebGLTexture,
      'material program': webgl.properties.get(material).currentProgram.program instanceof WebGLProgram,
      'material version': webgl.properties.get(material).__version === material.version,
      'program shaders': program.vertexShader instanceof WebGLShader && program.fragmentShader instanceof WebGLShader,
      'batch textures': batch._matricesTexture.isTexture && batch._indirectTexture.isTexture,
      'batch visibility': batch._visibilityChanged,
      // oxlint-disable-next-line typescript/no-explicit-any -- what three keeps private has no types
      'shadow frustum': (new THREE.PointLight().shadow as any)._frustum instanceof THREE.Frustum,
    };
    Reflect.set(camera, '_reversedDepth', true);
    const reversed = camera.reversedDepth;
    webgl.dispose();
    return { types: Object.entries(types).filter(([, each]) => each !== 'function'), values, reversed };
  });
  expect(found).toEqual({
    types: [],
    values: {
      'depth is reversed': false,
      'camera.reversedDepth': false,
      'list.opaque': 1,
      'list.transmissive': 0,
      'target framebuffer': true,
      'target multisampled framebuffer': true,
      'texture handle': true,
      'material program': true,
      'material version': true,
      'program shaders': true,
      'batch textures': true,
      'batch visibility': true,
      'shadow frustum': true,
    },
    reversed: true,
  });
});
