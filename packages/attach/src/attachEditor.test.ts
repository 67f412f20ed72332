import { PerspectiveCamera, Scene, type WebGLRenderer } from 'three';
import { expect, it } from 'vitest';
import { attachEditor } from './attachEditor';

it('refuses a language that it has not before anything is attached', () => {
  expect(() =>
    attachEditor(new Scene(), new PerspectiveCamera(), {} as WebGLRenderer, { language: 'fr' as 'es' }),
  ).toThrow('attachEditor: unknown language "fr"; use one of: en, es.');
});
