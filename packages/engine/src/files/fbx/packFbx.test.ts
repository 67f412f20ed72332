import { zlibSync } from 'three/addons/libs/fflate.module.js';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { checkModelFile } from '../../assets/readModel';
import { binaryOf, readGltfJson } from '../../guard/gltf/readGltfJson';
import { packFbx } from '../packFbx';

interface Json {
  nodes: { name?: string; mesh?: number; translation?: number[]; scale?: number[]; children?: number[] }[];
  materials: {
    name: string;
    pbrMetallicRoughness: { baseColorFactor: number[]; roughnessFactor: number; baseColorTexture?: { index: number } };
    normalTexture?: { index: number };
  }[];
  meshes: { primitives: { attributes: Record<string, number>; material: number }[] }[];
  accessors: { bufferView: number; byteOffset?: number; count: number; min?: number[]; max?: number[] }[];
  bufferViews: { byteOffset?: number; byteLength: number }[];
  images?: { name: string; bufferView: number }[];
  animations?: { name: string; channels: { target: { path: string } }[] }[];
}

/** A red square of 2 m with a picture, on a node at a height of 100 units; written as text, like an exporter's. */
function fbx({ texture = 'textures\\Wall.png', unit = 1 } = {}): string {
  const property = (name: string, type: string, ...values: (number | string)[]): string =>
    `P: "${name}", "${type}", "", "A",${values.join(',')}`;
  return `; FBX 7.4.0 project file
FBXHeaderExtension:  {
	FBXHeaderVersion: 1003
	FBXVersion: 7400
}
GlobalSettings:  {
	Version: 1000
	Properties70:  {
		P: "UpAxis", "int", "Integer", "",1
		P: "UpAxisSign", "int", "Integer", "",1
		P: "UnitScaleFactor", "double", "Number", "",${unit}
	}
}
Objects:  {
	Geometry: 10, "Geometry::Square", "Mesh" {
		Vertices: *12 {
			a: -100,0,-100,100,0,-100,100,0,100,-100,0,100
		}
		PolygonVertexIndex: *4 {
			a: 3,2,1,-1
		}
		GeometryVersion: 124
		LayerElementNormal: 0 {
			Version: 101
			Name: ""
			MappingInformationType: "ByPolygonVertex"
			ReferenceInformationType: "Direct"
			Normals: *12 {
				a: 0,2,0,0,2,0,0,2,0,0,2,0
			}
		}
		LayerElementUV: 0 {
			Version: 101
			Name: "UVMap"
			MappingInformationType: "ByPolygonVertex"
			ReferenceInformationType: "IndexToDirect"
			UV: *8 {
				a: 0,0,1,0,1,1,0,1
			}
			UVIndex: *4 {
				a: 0,1,2,3
			}
		}
		LayerElementMaterial: 0 {
			Version: 101
			Name: ""
			MappingInformationType: "AllSame"
			ReferenceInformationType: "IndexToDirect"
			Materials: *1 {
				a: 0
			}
		}
		Layer: 0 {
			Version: 100
			LayerElement:  {
				Type: "LayerElementNormal"
				TypedIndex: 0
			}
			LayerElement:  {
				Type: "LayerElementUV"
				TypedIndex: 0
			}
			LayerElement:  {
				Type: "LayerElementMaterial"
				TypedIndex: 0
			}
		}
	}
	Model: 20, "Model::Square", "Mesh" {
		Version: 232
		Properties70:  {
			${property('Lcl Translation', 'Lcl Translation', 0, 100, 0)}
		}
	}
	Material: 30, "Material::Wall", "" {
		Version: 102
		ShadingModel: "phong"
		Properties70:  {
			${property('DiffuseColor', 'Color', 1, 0, 0)}
			${property('SpecularColor', 'Color', 1, 1, 1)}
			${property('Shininess', 'double', 96)}
		}
	}
	Texture: 40, "Texture::Picture", "" {
		Type: "TextureVideoClip"
		FileName: "C:\\project\\${texture}"
		RelativeFilename: "${texture}"
	}
	Video: 50, "Video::Picture", "Clip" {
		Type: "Clip"
		FileName: "C:\\project\\${texture}"
		RelativeFilename: "${texture}"
	}
	AnimationStack: 60, "AnimStack::Rise", "" {
	}
	AnimationLayer: 61, "AnimLayer::Base", "" {
	}
	AnimationCurveNode: 62, "AnimCurveNode::T", "" {
		Properties70:  {
			P: "d|X", "Number", "", "A",0
			P: "d|Y", "Number", "", "A",100
			P: "d|Z", "Number", "", "A",0
		}
	}
	AnimationCurve: 63, "AnimCurve::", "" {
		Default: 0
		KeyVer: 4008
		KeyTime: *2 {
			a: 0,46186158000
		}
		KeyValueFloat: *2 {
			a: 100,300
		}
	}
}
Connections:  {
	C: "OO",20,0
	C: "OO",10,20
	C: "OO",30,20
	C: "OP",40,30, "DiffuseColor"
	C: "OO",50,40
	C: "OO",61,60
	C: "OO",62,61
	C: "OP",62,20, "Lcl Translation"
	C: "OP",63,62, "d|Y"
}
`;
}

/** The first bytes of a PNG, by which it is recognised. */
const png = Uint8Array.from([0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10]);

async function pack(entries: Record<string, string | Uint8Array<ArrayBuffer>>, path: string) {
  const files = Object.entries(entries).map(([name, content]) => [name, new File([content], name)] as const);
  const packed = await packFbx(new Map(files), path);
  const json = readGltfJson(packed.glb);
  checkModelFile(packed.glb, json);
  return { ...packed, json: json as unknown as Json, binary: binaryOf(packed.glb)! };
}

/** Browser interfaces that GLTFExporter needs and Node lacks. */
class BlobReader {
  result: ArrayBuffer | null = null;
  onloadend: () => void = () => {};
  readAsArrayBuffer(blob: Blob): void {
    void blob.arrayBuffer().then((buffer) => {
      this.result = buffer;
      this.onloadend();
    });
  }
}

beforeEach(() => {
  vi.stubGlobal('FileReader', BlobReader);
  // Node decodes no images: here each one that is recognised counts as decoded
  vi.stubGlobal('createImageBitmap', async () => ({ close() {} }));
});
afterEach(() => vi.unstubAllGlobals());

describe('packFbx', () => {
  it('makes a GLB in metres, with v from the top and normals of length 1', async () => {
    const { json, binary, notes } = await pack({ 'house/a.fbx': fbx(), 'house/textures/wall.PNG': png }, 'house/a.fbx');
    expect(notes).toEqual([]);
    const floats = (accessor: number): number[] => {
      const { bufferView, byteOffset = 0, count } = json.accessors[accessor];
      const view = json.bufferViews[bufferView];
      const from = (view.byteOffset ?? 0) + byteOffset;
      return [...new Float32Array(binary.slice(from, from + view.byteLength).buffer)].slice(0, count * 3);
    };
    const [{ attributes }] = json.meshes[0].primitives;
    expect(json.accessors[attributes.POSITION]).toMatchObject({ min: [-100, 0, -100], max: [100, 0, 100] });
    expect(floats(attributes.NORMAL).slice(0, 3)).toEqual([0, 1, 0]);
    const positions = floats(attributes.POSITION);
    const corner = [0, 1, 2, 3, 4, 5].find((i) => positions[i * 3] === -100 && positions[i * 3 + 2] === 100)!;
    expect(floats(attributes.TEXCOORD_0).slice(corner * 2, corner * 2 + 2)).toEqual([0, 1]);
    const root = json.nodes.find(({ name }) => name === 'a')!;
    expect(root.scale).toEqual([0.01, 0.01, 0.01]);
    expect(json.nodes.find(({ name }) => name === 'Square')!.translation).toEqual([0, 100, 0]);
  });

  it('takes materials and their textures along, found by other case and folder', async () => {
    const { json, used } = await pack({ 'house/a.fbx': fbx(), 'house/textures/wall.PNG': png }, 'house/a.fbx');
    const [material] = json.materials;
    expect(material.name).toBe('Wall');
    expect(material.pbrMetallicRoughness.baseColorFactor[0]).toBeCloseTo(1, 10);
    expect(material.pbrMetallicRoughness.baseColorFactor.slice(1)).toEqual([0, 0, 1]);
    expect(material.pbrMetallicRoughness.roughnessFactor).toBeCloseTo((2 / 98) ** 0.25, 6);
    expect(material.pbrMetallicRoughness.baseColorTexture).toEqual({ index: 0 });
    expect(json.images).toMatchObject([{ name: 'wall.PNG' }]);
    expect([...used]).toEqual(['house/textures/wall.PNG']);
  });

  it('takes clips along, by name', async () => {
    const { json } = await pack({ 'a.fbx': fbx(), 'wall.png': png }, 'a.fbx');
    expect(json.animations!.map(({ name }) => name)).toEqual(['Rise']);
    expect(json.animations![0].channels.map(({ target }) => target.path)).toContain('translation');
  });

  it('goes by the unit of the file', async () => {
    const { json } = await pack({ 'a.fbx': fbx({ unit: 100 }), 'wall.png': png }, 'a.fbx');
    const root = json.nodes.find(({ name }) => name === 'a');
    expect(root!.scale ?? [1, 1, 1]).toEqual([1, 1, 1]);
  });

  it('names the textures that are missing', async () => {
    const { json, notes } = await pack({ 'a.fbx': fbx() }, 'a.fbx');
    expect(notes).toEqual([
      'a.fbx: these textures were not found: Wall.png. Drop the whole folder, or all files together.',
    ]);
    expect(json.materials[0].pbrMetallicRoughness).not.toHaveProperty('baseColorTexture');
  });

  /** A node of a binary FBX 7.4: name, properties as bytes, children. */
  type Node = [name: string, properties: Uint8Array[], inner?: Node[]];
  const words = (...values: number[]): Uint8Array => new Uint8Array(Uint32Array.from(values).buffer);
  const letters = (text: string): Uint8Array => Uint8Array.from(text, (letter) => letter.charCodeAt(0));
  const join = (...parts: Uint8Array[]): Uint8Array<ArrayBuffer> => Uint8Array.from(parts.flatMap((part) => [...part]));
  const text = (value: string): Uint8Array => join(letters('S'), words(value.length), letters(value));
  const whole = (value: number): Uint8Array => join(letters('I'), words(value));
  const packed = (type: string, count: number, data: Uint8Array): Uint8Array => {
    const bytes = zlibSync(data);
    const result = new Uint8Array(13 + bytes.length);
    result.set(join(letters(type), words(count, 1, bytes.length)));
    result.set(bytes, 13);
    return result;
  };
  function binary(nodes: Node[]): Uint8Array<ArrayBuffer> {
    const bytes: Uint8Array[] = [letters('Kaydara FBX Binary  \0\x1a\0'), words(7400)];
    let at = 27;
    const write = ([name, properties, inner = []]: Node): void => {
      const head = new Uint8Array(13);
      bytes.push(head, letters(name), ...properties);
      at += 13 + name.length + properties.reduce((sum, { length }) => sum + length, 0);
      inner.forEach(write);
      new DataView(head.buffer).setUint32(0, at, true);
      new DataView(head.buffer).setUint32(4, properties.length, true);
      head[12] = name.length;
    };
    nodes.forEach(write);
    bytes.push(new Uint8Array(201));
    const result = new Uint8Array(bytes.reduce((sum, { length }) => sum + length, 0));
    let end = 0;
    for (const each of bytes) {
      result.set(each, end);
      end += each.length;
    }
    return result;
  }

  it('writes nothing into what all objects share', async () => {
    const before = Object.getOwnPropertyNames(Object.prototype);
    const named = '\t__proto__: "polluted", "b", "c" {\n\t}\n';
    const file = fbx().replace('Objects:  {\n', `Objects:  {\n${named}`);
    const nodes: Node[] = [
      ['Objects', [], [['__proto__', [whole(5), text('a'), text('b')], [['id', [text('polluted')]]]]]],
    ];
    try {
      for (const content of [file, file.replace('__proto__', 'constructor'), binary(nodes)]) {
        await expect(pack({ 'a.fbx': content }, 'a.fbx')).rejects.toThrow(
          /its FBX data cannot be read \(it has an entry of the name (__proto__|constructor)\)/,
        );
      }
      expect(Object.getOwnPropertyNames(Object.prototype)).toEqual(before);
      expect('polluted' in {}).toBe(false);
      expect('polluted' in Object).toBe(false);
    } finally {
      for (const name of Object.getOwnPropertyNames(Object.prototype))
        if (!before.includes(name)) Reflect.deleteProperty(Object.prototype, name);
      Reflect.deleteProperty(Object, 'polluted');
    }
  });

  it('refuses what would take memory or time without end', async () => {
    const geometry = (...inner: Node[]): Uint8Array<ArrayBuffer> =>
      binary([['Objects', [], [['Geometry', [whole(1), text('a'), text('Mesh')], inner]]]]);
    const absurd: [string | Uint8Array<ArrayBuffer>, RegExp][] = [
      // 100 kB that unpack to 100 MB
      [geometry(['Vertices', [packed('d', 3, new Uint8Array(100_000_000))]]), /come to more than it says/],
      [geometry(['Vertices', [packed('d', 1e9, new Uint8Array(8))]]), /its arrays come to more than [\d,]+ bytes/],
      [
        geometry(['PolygonVertexIndex', [packed('i', 40_000, new Uint8Array(160_000))]]),
        /a face of it has 40,000 corners: cut it into triangles/,
      ],
      [fbx().replace('a: 3,2,1,-1', `a: ${'3,2,1,'.repeat(20_000)}-1`), /a face of it has 60,001 corners/],
      [fbx().replace(/(KeyValueFloat: \*\d+ \{\s+a: [-\d.]+,)/, '$11e300,'), /keys of its clips are too far/],
    ];
    for (const [content, message] of absurd) {
      await expect(pack({ 'a.fbx': content }, 'a.fbx')).rejects.toThrow(message);
    }
  });

  it('says what is wrong with what it cannot read', async () => {
    await expect(pack({ 'a.fbx': 'hello' }, 'a.fbx')).rejects.toThrow(/its FBX data cannot be read .* export it again/);
    const old = fbx().replace('FBXVersion: 7400', 'FBXVersion: 6100');
    await expect(pack({ 'a.fbx': old }, 'a.fbx')).rejects.toThrow(/FBX version not supported, FileVersion: 6100/);
    const cut = `Kaydara FBX Binary  \0\x1a\0${'\0'.repeat(40)}`;
    await expect(pack({ 'a.fbx': cut }, 'a.fbx')).rejects.toThrow(/its FBX data cannot be read/);
  });
});
