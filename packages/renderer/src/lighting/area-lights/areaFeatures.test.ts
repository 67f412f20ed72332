import { describe, expect, it } from 'vitest';
import { MicroShaderRegistry } from '../../microshaders';
import { parseMicroShader } from '../../microshaders/parseMicroShader';
import { areaFeaturesChunk, needShape } from './areaFeatures';
import all from './areaFeatures.glsl?raw';
import { areaShapes } from './areaRecord';

const defined = (text: string) => [...text.matchAll(/#define (\w+)/g)].map(([, name]) => name);

describe('the shapes that shaders have code for', () => {
  it('are all of them in the file', () => {
    expect(defined(all)).toEqual(defined(areaFeaturesChunk(7)));
    expect(defined(all)).toHaveLength(Object.keys(areaShapes).length);
  });

  it('are those met so far, and stay', () => {
    const registry = new MicroShaderRegistry();
    registry.add([parseMicroShader('areaFeatures', all)]);
    const text = () => defined(registry.header(['areaFeatures']));
    needShape(registry, areaShapes.tube);
    expect(text()).toEqual(['FAROL_AREA_TUBES']);
    needShape(registry, areaShapes.rectangle);
    needShape(registry, areaShapes.tube);
    expect(text()).toEqual(['FAROL_AREA_RECTANGLES', 'FAROL_AREA_TUBES']);
  });
});
