export { formatMicroShaderXML } from './formatMicroShaderXML';
export { microShaderSources } from './microShaderSources';
