import type { Page } from '@playwright/test';

/** A file to be dropped or chosen. */
export interface TestFile {
  readonly name: string;
  readonly bytes: Buffer;
}

/** Corners and outward normals of a box of 1 m: six faces of four corners. */
function box(): { positions: number[]; normals: number[]; indices: number[] } {
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  for (let axis = 0; axis < 3; axis++) {
    for (const side of [1, -1]) {
      const first = positions.length / 3;
      for (const [u, v] of [
        [-1, -1],
        [1, -1],
        [1, 1],
        [-1, 1],
      ]) {
        const corner = [0, 0, 0];
        corner[axis] = side / 2;
        corner[(axis + 1) % 3] = (side * u) / 2;
        corner[(axis + 2) % 3] = v / 2;
        positions.push(...corner);
        normals.push(...[0, 1, 2].map((i) => (i === axis ? side : 0)));
      }
      indices.push(...[0, 1, 2, 0, 2, 3].map((i) => first + i));
    }
  }
  return { positions, normals, indices };
}

/** A red, rough box as a .gltf with its data inside. */
export function redBox(name = 'box.gltf'): TestFile {
  const { positions, normals, indices } = box();
  const data = Buffer.concat([
    Buffer.from(new Float32Array(positions).buffer),
    Buffer.from(new Float32Array(normals).buffer),
    Buffer.from(new Uint16Array(indices).buffer),
  ]);
  const gltf = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ name: 'Box', mesh: 0 }],
    meshes: [{ name: 'Box', primitives: [{ attributes: { POSITION: 0, NORMAL: 1 }, indices: 2, material: 0 }] }],
    materials: [{ name: 'Red', pbrMetallicRoughness: { baseColorFactor: [1, 0, 0, 1], metallicFactor: 0 } }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 24, type: 'VEC3', min: [-0.5, -0.5, -0.5], max: [0.5, 0.5, 0.5] },
      { bufferView: 1, componentType: 5126, count: 24, type: 'VEC3' },
      { bufferView: 2, componentType: 5123, count: 36, type: 'SCALAR' },
    ],
    bufferViews: [
      { buffer: 0, byteLength: 288 },
      { buffer: 0, byteOffset: 288, byteLength: 288 },
      { buffer: 0, byteOffset: 576, byteLength: 72 },
    ],
    buffers: [{ byteLength: data.length, uri: `data:application/octet-stream;base64,${data.toString('base64')}` }],
  };
  return { name, bytes: Buffer.from(JSON.stringify(gltf)) };
}

/** The red box with a morph target `Tall`, which puts its upper corners 1 m higher. */
export function growingBox(name = 'growing.gltf'): TestFile {
  const gltf = JSON.parse(redBox().bytes.toString()) as ReturnType<typeof JSON.parse>;
  const { positions } = box();
  const grown = Buffer.from(
    new Float32Array(positions.map((_, i) => (i % 3 === 1 && positions[i] > 0 ? 1 : 0))).buffer,
  );
  const [mesh] = gltf.meshes;
  mesh.primitives[0].targets = [{ POSITION: 3 }];
  mesh.extras = { targetNames: ['Tall'] };
  gltf.accessors.push({ bufferView: 3, componentType: 5126, count: 24, type: 'VEC3', min: [0, 0, 0], max: [0, 1, 0] });
  gltf.bufferViews.push({ buffer: 1, byteLength: 288 });
  gltf.buffers.push({ byteLength: 288, uri: `data:application/octet-stream;base64,${grown.toString('base64')}` });
  return { name, bytes: Buffer.from(JSON.stringify(gltf)) };
}

/** A sky of one colour as Radiance HDR, 4 by 2 pixels. @param light - of each channel */
export function plainSky(light: number, name = 'sky.hdr'): TestFile {
  const exponent = Math.ceil(Math.log2(light)) + 1;
  const mantissa = Math.round((light / 2 ** exponent) * 256);
  const pixels = Array.from({ length: 8 }, () => [mantissa, mantissa, mantissa, exponent + 128]).flat();
  const head = Buffer.from('#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n');
  return { name, bytes: Buffer.concat([head, Buffer.from(pixels)]) };
}

/** Drops files from outside on the middle of an element. */
export async function dropFiles(page: Page, selector: string, files: readonly TestFile[]): Promise<void> {
  const data = files.map(({ name, bytes }) => ({ name, base64: bytes.toString('base64') }));
  await page.locator(selector).evaluate((element, list) => {
    const transfer = new DataTransfer();
    for (const { name, base64 } of list) {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      transfer.items.add(new File([bytes], name));
    }
    const { left, top, width, height } = element.getBoundingClientRect();
    const place = { clientX: left + width / 2, clientY: top + height / 2 };
    for (const type of ['dragenter', 'dragover', 'drop']) {
      element.dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, dataTransfer: transfer, ...place }));
    }
  }, data);
}

/** The colour of the picture (sRGB bytes) at a place of it, from 0 to 1, y down. */
export const pixelAt = (page: Page, x: number, y: number): Promise<number[]> =>
  page.evaluate(
    ([u, v]) => {
      const { viewport } = window.editor;
      viewport.renderNow();
      const { canvas } = viewport;
      const copy = document.createElement('canvas');
      copy.width = canvas.width;
      copy.height = canvas.height;
      const context = copy.getContext('2d')!;
      context.drawImage(canvas, 0, 0);
      return [...context.getImageData(Math.round(u * canvas.width), Math.round(v * canvas.height), 1, 1).data];
    },
    [x, y] as const,
  );
