import { gatherDeclarations } from '@farol/tools/scriptDeclarations';
import { describe, expect, it } from 'vitest';
import { scriptTemplate } from '../../model/scriptTemplate';
import { importEdit } from './importable';
import { ScriptService } from './ScriptService';

/** Created once, since TypeScript reads four megabytes of declarations. */
const service = new ScriptService(gatherDeclarations());
const template = scriptTemplate('Spin');

/** Sets a script's text, without its '|'. @returns the position of the '|' */
function write(text: string, name = 'Spin'): number {
  const at = text.indexOf('|');
  service.change([[name, text.replace('|', '')]]);
  return at;
}

/** The template with a line added at the end of its update. */
const withLine = (line: string): string => template.replace('deltaSeconds);\n', `deltaSeconds);\n    ${line}\n`);

const labels = (at: number): string[] =>
  (service.completions('Spin', at, false)?.options ?? []).map(({ label }) => label);

describe('a script', () => {
  it('has no errors as it is made, in TypeScript and in JavaScript', () => {
    write(template);
    write(scriptTemplate('Old.js'), 'Old.js');
    expect(service.diagnostics('Spin')).toEqual([]);
    expect(service.diagnostics('Old.js')).toEqual([]);
    service.change([['Old.js', null]]);
  });

  it('is offered the members of an object of the engine, and none that are internal', () => {
    const found = labels(write(withLine('this.gameObject.|')));
    expect(found).toEqual(expect.arrayContaining(['addComponent', 'children', 'name', 'object3D', 'transform']));
    expect(found).not.toContain('refreshActive');
  });

  it('is offered its own fields, and members of three', () => {
    expect(labels(write(withLine('this.|')))).toEqual(expect.arrayContaining(['speed', 'gameObject', 'simulate']));
    expect(labels(write(withLine('this.gameObject.object3D.|')))).toContain('rotateY');
  });

  it('is told errors of types and of syntax by line', () => {
    write(withLine("this.speed = 'fast';"));
    expect(service.diagnostics('Spin')).toMatchObject([
      { kind: 'types', line: 13, message: "Type 'string' is not assignable to type 'number'." },
    ]);
    write(withLine('this.speed = ;'));
    expect(service.diagnostics('Spin')).toMatchObject([{ kind: 'syntax', line: 13 }]);
  });

  it('is told types and how functions are called', () => {
    const help = service.help('Spin', write(withLine('this.sp|eed = 1;')));
    expect(help).toMatchObject({ type: '(property) speed: number' });
    const signature = service.signature('Spin', write(withLine('this.gameObject.object3D.lookAt(1, |)')));
    expect(signature).toMatchObject({ parameters: ['x: number', 'y: number', 'z: number'], active: 1 });
  });

  it('is offered what it could import, with the module', () => {
    const at = write(withLine('new Vec|'));
    const found = service.completions('Spin', at, false)!.options.find(({ label }) => label === 'Vector3');
    expect(found).toMatchObject({ module: 'three' });
    expect(service.completionHelp('Spin', at, found!)?.help).toMatch(/3D vector/);
  });

  it('sees other scripts, in folders too, and where their names are declared', () => {
    write('export const twice = (value: number): number => 2 * value;\n', 'Tools/twice');
    const text = withLine('twi|ce(this.speed);').replace('\n', "\nimport { twice } from './Tools/twice';\n");
    const at = write(text);
    expect(service.diagnostics('Spin')).toEqual([]);
    expect(service.definition('Spin', at)).toEqual({ script: 'Tools/twice', line: 1 });
    service.change([['Tools/twice', null]]);
    expect(service.diagnostics('Spin')).toMatchObject([{ line: 2 }]);
  });
});

describe('an import', () => {
  it('is added to one of the same module, or after the others, or at the top', () => {
    const edit = (text: string): string => {
      const { at, insert } = importEdit(text, 'Vector3', 'three');
      return text.slice(0, at) + insert + text.slice(at);
    };
    expect(edit("import { Color } from 'three';\nx;")).toBe("import { Color, Vector3 } from 'three';\nx;");
    expect(edit("import {\n  Color,\n} from 'three';\n")).toBe("import {\n  Color, Vector3\n} from 'three';\n");
    expect(edit("import {} from 'three';\n")).toBe("import { Vector3 } from 'three';\n");
    expect(edit("import a from './a';\nx;")).toBe("import a from './a';\nimport { Vector3 } from 'three';\nx;");
    expect(edit('x;')).toBe("import { Vector3 } from 'three';\nx;");
  });
});
