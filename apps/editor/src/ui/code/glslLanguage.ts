import { StreamLanguage } from '@codemirror/language';
import { shader } from '@codemirror/legacy-modes/mode/clike';
import type { Extension } from '@codemirror/state';

/** Syntax highlighting for GLSL. */
export const glslLanguage = (): Extension => StreamLanguage.define(shader);
