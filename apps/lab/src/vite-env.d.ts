/// <reference types="vite/client" />

declare module 'virtual:stanford-dragon/*' {
  /** Address of the Stanford dragon's PLY; null if it is not part of the build. */
  const url: string | null;
  export default url;
}
