import { describe, expect, it } from 'vitest';
import { MicroShaderRegistry } from '../../microshaders';
import { parseMicroShader } from '../../microshaders/parseMicroShader';
import { areaFeaturesChunk, needArea } from './areaFeatures';
import all from './areaFeatures.glsl?raw';
import { areaShapes } from './areaRecord';

const kindsIn = (text: string) => Number(/#define FAROL_AREA_KINDS (\d+)/.exec(text)![1]);

describe('the kinds of area lights that shaders have code for', () => {
  it('are all of them in the file', () => {
    expect(kindsIn(all)).toBe(kindsIn(areaFeaturesChunk(31)));
    expect(kindsIn(all)).toBe(2 ** (Object.keys(areaShapes).length + 2) - 1);
  });

  it('are those met so far, and stay', () => {
    const registry = new MicroShaderRegistry();
    registry.add([parseMicroShader('areaFeatures', all)]);
    const text = () => kindsIn(registry.header(['areaFeatures']));
    needArea(registry, areaShapes.tube, false);
    expect(text()).toBe(4 + 16);
    needArea(registry, areaShapes.rectangle, false);
    needArea(registry, areaShapes.tube, false);
    expect(text()).toBe(5 + 16);
    needArea(registry, areaShapes.tube, true);
    expect(text()).toBe(5 + 16 + 8);
  });
});
