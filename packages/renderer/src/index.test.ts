import { expect, it } from 'vitest';
import * as authoring from './authoring';
import * as entry from '.';

it('exports what a page draws with, and no part of what techniques are made of: those are in /authoring', () => {
  expect(Object.keys(entry).toSorted()).toEqual([
    'FarolRenderer',
    'setAreaLightShape',
    'setLightCookie',
    'setLightProfile',
    'setShading',
    'techniques',
    'views',
  ]);
  expect(Object.keys(entry).filter((name) => name in authoring)).toEqual([]);
});
