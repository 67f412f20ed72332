import { describe, expect, it } from 'vitest';
import { fileNameOf } from './fileNameOf';

describe('fileNameOf', () => {
  it('keeps letters of all scripts with their marks, and leaves out what paths, shells and systems read otherwise', () => {
    expect(fileNameOf('Lámpara नमस्ते 灯 2_a-b')).toBe('Lámpara नमस्ते 灯 2_a-b');
    expect(fileNameOf('../..\\a/b:c*?"<>|\0\n.glb')).toBe('abcglb');
    expect(fileNameOf('\u202egnp.exe')).toBe('gnpexe');
  });

  it('gives a name where nothing is left, and to those of devices', () => {
    expect(fileNameOf(' /// ')).toBe('Scene');
    expect(fileNameOf('CON')).toBe('CON scene');
    expect(fileNameOf('lpt1')).toBe('lpt1 scene');
  });

  it('is short enough for any system, and cuts no letter apart', () => {
    const long = fileNameOf('𠮷'.repeat(300));
    expect(new TextEncoder().encode(`${long}.farol`).length).toBeLessThanOrEqual(255);
    expect(() => encodeURIComponent(long)).not.toThrow();
  });
});
