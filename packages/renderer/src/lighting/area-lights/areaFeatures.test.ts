import { describe, expect, it } from 'vitest';
import { MicroShaderRegistry } from '../../microshaders';
import { parseMicroShader } from '../../microshaders/parseMicroShader';
import { areaFeaturesChunk, needShape } from './areaFeatures';
import all from './areaFeatures.glsl?raw';
import { areaShapes } from './areaRecord';

const shapesIn = (text: string) => Number(/#define FAROL_AREA_SHAPES (\d+)/.exec(text)![1]);

describe('the shapes that shaders have code for', () => {
  it('are all of them in the file', () => {
    expect(shapesIn(all)).toBe(shapesIn(areaFeaturesChunk(7)));
    expect(shapesIn(all)).toBe(2 ** Object.keys(areaShapes).length - 1);
  });

  it('are those met so far, and stay', () => {
    const registry = new MicroShaderRegistry();
    registry.add([parseMicroShader('areaFeatures', all)]);
    const text = () => shapesIn(registry.header(['areaFeatures']));
    needShape(registry, areaShapes.tube);
    expect(text()).toBe(4);
    needShape(registry, areaShapes.rectangle);
    needShape(registry, areaShapes.tube);
    expect(text()).toBe(5);
  });
});
