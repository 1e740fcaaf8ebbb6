// Pictures of one size as the layers of one texture, filled one after another.
import { ExternalTexture, type Texture, type WebGLRenderer } from "three";

export class PageArray {
  readonly texture: Texture;
  private readonly gl: WebGL2RenderingContext;
  private readonly handle: WebGLTexture;
  private readonly levels: number;

  constructor(
    private readonly renderer: WebGLRenderer,
    readonly width: number,
    readonly height: number,
    readonly layers: number,
    levels: number,
    sharpness: number,
    quick: boolean,
  ) {
    this.gl = renderer.getContext() as WebGL2RenderingContext;
    const gl = this.gl;
    this.levels = Math.min(levels, 1 + Math.floor(Math.log2(Math.max(width, height))));
    this.handle = gl.createTexture();
    this.bound(() => {
      gl.texStorage3D(gl.TEXTURE_2D_ARRAY, this.levels, gl.RGBA8, width, height, layers);
      gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MIN_FILTER, quick ? gl.LINEAR_MIPMAP_NEAREST : gl.LINEAR_MIPMAP_LINEAR);
      gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
      gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
      gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
      const extension = gl.getExtension("EXT_texture_filter_anisotropic");
      if (extension && sharpness > 1) gl.texParameterf(gl.TEXTURE_2D_ARRAY, extension.TEXTURE_MAX_ANISOTROPY_EXT, sharpness);
    });
    this.texture = new ExternalTexture(this.handle);
  }

  // `picture` has at most the layer's size and comes into its upper left corner; without its smaller copies.
  put(layer: number, level: number, picture: TexImageSource & { width: number; height: number }): void {
    const gl = this.gl;
    this.bound(() => {
      gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, level, 0, 0, layer, picture.width, picture.height, 1, gl.RGBA, gl.UNSIGNED_BYTE, picture);
    });
  }

  // The picture stretched over the whole layer, and its smaller copies.
  putWhole(layer: number, picture: ImageBitmap): void {
    let source: CanvasImageSource = picture;
    for (let level = 0; level < this.levels; level++) {
      const copy = new OffscreenCanvas(Math.max(this.width >> level, 1), Math.max(this.height >> level, 1));
      const drawing = copy.getContext("2d", { alpha: false })!;
      drawing.imageSmoothingQuality = "high";
      drawing.drawImage(source, 0, 0, copy.width, copy.height);
      this.put(layer, level, copy);
      source = copy;
    }
  }

  makeSmallerCopies(): void {
    this.bound(() => this.gl.generateMipmap(this.gl.TEXTURE_2D_ARRAY));
  }

  private bound(work: () => void): void {
    const gl = this.gl;
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, this.handle);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 4);
    work();
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, null);
    this.renderer.resetState();
  }
}
