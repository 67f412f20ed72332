declare module 'virtual:script-declarations' {
  /** URL of a JSON file with `ScriptDeclarations`, made by `@farol/tools/scriptDeclarations`. */
  const url: string;
  export default url;
}

/** The complete three module, see `@farol/tools/wholeThree`. */
declare module 'virtual:whole-three' {
  export * from 'three';
}

/**
 * The complete engine with its field declarations, apart from the first frame's code; see `@farol/tools/wholeThree`.
 */
declare module 'virtual:whole-engine' {
  export * from '@farol/engine';
}

declare module 'virtual:whole-engine-fields' {
  export * from '@farol/engine/fields';
}
