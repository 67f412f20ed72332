declare module '*.ply.gz?url' {
  const url: string;
  export default url;
}
