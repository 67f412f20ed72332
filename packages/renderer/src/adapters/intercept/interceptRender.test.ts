import { Camera, Object3D, type WebGLRenderer } from 'three';
import { expect, it } from 'vitest';
import { type Interceptor, interceptRender } from './interceptRender';

const scene = new Object3D();
const camera = new Camera();

/** A renderer that records which function draws. */
function renderer() {
  const drawn: string[] = [];
  const webgl = { render: () => void drawn.push('three') } as unknown as WebGLRenderer;
  const passing =
    (name: string): Interceptor =>
    (scene, camera, next) => {
      drawn.push(name);
      next(scene, camera);
    };
  const draw = () => {
    drawn.length = 0;
    webgl.render(scene, camera);
    return drawn.join(' ');
  };
  return { webgl, drawn, passing, draw };
}

it('asks the last one first, and gives the renderer its own render back with the last that goes, in any order', () => {
  const { webgl, passing, draw } = renderer();
  const { render } = webgl;
  const first = interceptRender(webgl, passing('first'));
  const hooked = webgl.render;
  const second = interceptRender(webgl, passing('second'));
  expect(webgl.render).toBe(hooked);
  expect(draw()).toBe('second first three');
  first.remove();
  first.remove();
  expect(draw()).toBe('second three');
  second.remove();
  expect(webgl.render).toBe(render);
  expect(draw()).toBe('three');
});

it('has three draw what is drawn meanwhile, also after an error', () => {
  const { webgl, drawn, passing, draw } = renderer();
  interceptRender(webgl, passing('first'));
  const { remove, stock } = interceptRender(webgl, (scene, camera) => {
    drawn.push('second');
    webgl.render(scene, camera);
    throw new Error('thrown');
  });
  expect(draw).toThrow('thrown');
  expect(drawn).toEqual(['second', 'three']);
  remove();
  expect(draw()).toBe('first three');
  drawn.length = 0;
  stock(scene, camera);
  expect(drawn).toEqual(['three']);
});

it("keeps another tool's wrapper, and comes before it when asked again", () => {
  const { webgl, drawn, passing, draw } = renderer();
  const { remove } = interceptRender(webgl, passing('first'));
  const wrapped = webgl.render;
  const wrapper: WebGLRenderer['render'] = (scene, camera) => {
    drawn.push('tool');
    wrapped(scene, camera);
  };
  webgl.render = wrapper;
  expect(draw()).toBe('tool first three');
  remove();
  expect(webgl.render).toBe(wrapper);
  expect(draw()).toBe('tool three');
  const again = interceptRender(webgl, passing('again'));
  expect(draw()).toBe('again tool three');
  again.remove();
  expect(webgl.render).toBe(wrapper);
});
