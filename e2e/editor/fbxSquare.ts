import type { TestFile } from './models';

/** A block of FBX text, its lines indented by one tab more than itself. */
const block = (head: string, ...lines: readonly string[]): string =>
  `${head} {\n${lines.map((line) => line.replaceAll(/^/gm, '\t')).join('\n')}\n}`;

const list = (name: string, ...values: readonly number[]): string =>
  block(`${name}: *${values.length}`, `a: ${values.join(',')}`);

/** A green square of 2 m as FBX text, made here, with a clip 'Rise' that lifts it. */
const text = [
  '; FBX 7.4.0 project file',
  block('FBXHeaderExtension: ', 'FBXHeaderVersion: 1003', 'FBXVersion: 7400'),
  block('GlobalSettings: ', 'Version: 1000', block('Properties70: ', 'P: "UpAxis", "int", "Integer", "",1')),
  block(
    'Objects: ',
    block(
      'Geometry: 10, "Geometry::Square", "Mesh"',
      list('Vertices', -100, 0, -100, 100, 0, -100, 100, 0, 100, -100, 0, 100),
      list('PolygonVertexIndex', 3, 2, 1, -1),
      'GeometryVersion: 124',
      block(
        'LayerElementNormal: 0',
        'MappingInformationType: "ByPolygonVertex"',
        'ReferenceInformationType: "Direct"',
        list('Normals', 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0),
      ),
      block(
        'LayerElementMaterial: 0',
        'MappingInformationType: "AllSame"',
        'ReferenceInformationType: "IndexToDirect"',
        list('Materials', 0),
      ),
    ),
    block('Model: 20, "Model::Square", "Mesh"', 'Version: 232', block('Properties70: ', 'P: "Show", "bool", "", "",1')),
    block(
      'Material: 30, "Material::Green", ""',
      'ShadingModel: "phong"',
      block('Properties70: ', 'P: "DiffuseColor", "Color", "", "A",0,1,0'),
    ),
    block('AnimationStack: 60, "AnimStack::Rise", ""', 'Version: 100'),
    block('AnimationLayer: 61, "AnimLayer::Base", ""', 'Version: 100'),
    block(
      'AnimationCurveNode: 62, "AnimCurveNode::T", ""',
      block('Properties70: ', 'P: "d|X", "Number", "", "A",0', 'P: "d|Y", "Number", "", "A",0'),
    ),
    block(
      'AnimationCurve: 63, "AnimCurve::", ""',
      'Default: 0',
      'KeyVer: 4008',
      list('KeyTime', 0, 46186158000),
      list('KeyValueFloat', 0, 100),
    ),
  ),
  block(
    'Connections: ',
    ...['C: "OO",20,0', 'C: "OO",10,20', 'C: "OO",30,20', 'C: "OO",61,60', 'C: "OO",62,61'],
    ...['C: "OP",62,20, "Lcl Translation"', 'C: "OP",63,62, "d|Y"'],
  ),
  '',
].join('\n');

export const fbxSquare: TestFile = { name: 'square.fbx', bytes: Buffer.from(text) };
