"""ONNX files with the names and shapes of real models, and answers that can be foretold.

The segmenters keep the picture's colours at a quarter of the encoder's square, 256 x 256, in what the encoder gives. The decoder takes
the colour at the point that it is asked about: its masks are what has that colour, so that each thing on a picture of plain colours is a
mask. It thinks best of red things: predicted IoU is 0.9 + 0.1 * red, and less of the other masks of the same point.

The embedder's vector of a picture is its mean colour; of a text the mean of the colours of its words.
"""

import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper

SIDE, COARSE = 1024, 256
MEAN, DEVIATION = np.array([123.675, 116.28, 103.53], np.float32), np.array([58.395, 57.12, 57.375], np.float32)
NEAR = 0.5  # of colours, by the sum of differences of the model's values
WORDS = {"red": (1, 0, 0), "green": (0, 1, 0), "blue": (0, 0, 1), "tin": (0.2, 0.2, 0.2)}
COLOUR_MEAN = np.array([0.48145466, 0.4578275, 0.40821073], np.float32)
COLOUR_DEVIATION = np.array([0.26862954, 0.26130258, 0.27577711], np.float32)


class Graph:
    """Nodes one after the other; constants by value."""

    def __init__(self):
        self.nodes, self.constants = [], []

    def constant(self, value, dtype=np.float32):
        name = f"c{len(self.constants)}"
        self.constants.append(numpy_helper.from_array(np.asarray(value, dtype=dtype), name))
        return name

    def __call__(self, kind, *inputs, output=None, name=None, **attributes):
        output = output or f"t{len(self.nodes)}"
        self.nodes.append(helper.make_node(kind, list(inputs), [output], name=name or output, **attributes))
        return output

    def write(self, file, inputs, outputs):
        """inputs, outputs: {name: (shape, type)}; a text in a shape is a size that is left open."""
        ports = [[helper.make_tensor_value_info(name, kind, shape) for name, (shape, kind) in some.items()] for some in (inputs, outputs)]
        graph = helper.make_graph(self.nodes, "made_for_tests", *ports, initializer=self.constants)
        model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 17)], ir_version=9)
        onnx.checker.check_model(model)
        onnx.save(model, file)
        return str(file)


FLOAT, BYTE, LONG = TensorProto.FLOAT, TensorProto.UINT8, TensorProto.INT64


def encoder_input(layout):
    """Name, shape and type of what an encoder takes, by the form of the export."""
    return {
        "first": ("input_image", (1, 3, SIDE, SIDE), FLOAT),
        "open": ("x", ("batch", 3, SIDE, SIDE), FLOAT),
        "half": ("image", (1, 3, SIDE, SIDE), TensorProto.FLOAT16),
        "last_open": ("input_image", ("image_height", "image_width", 3), FLOAT),
        "last_bytes": ("image", (SIDE, SIDE, 3), BYTE),
        "last_batch": ("image", (1, SIDE, SIDE, 3), BYTE),
    }[layout]


def normalised(graph, layout):
    """The picture as (1, 3, 1024, 1024) of the values that SAM was trained with, as exports do it that have this inside."""
    name, shape, kind = encoder_input(layout)
    value = graph("Cast", name, to=FLOAT)
    if layout in ("first", "open", "half"):
        return value
    if len(shape) == 3:
        value = graph("Unsqueeze", value, graph.constant([0], np.int64))
    value = graph("Div", graph("Sub", value, graph.constant(MEAN)), graph.constant(DEVIATION))
    value = graph("Transpose", value, perm=[0, 3, 1, 2])
    rest = graph("Sub", graph.constant([1, 3, SIDE, SIDE], np.int64), graph("Shape", value))
    return graph("Pad", value, graph("Concat", graph.constant([0] * 4, np.int64), rest, axis=0))


def widened(graph, value, channels, of, output):
    """`of` channels become `channels`; the others are 0."""
    pads = graph.constant([0, 0, 0, 0, 0, channels - of, 0, 0], np.int64)
    return graph("Pad", value, pads, output=output)


def sam_encoder(file, layout="first", mobile=False, output="image_embeddings"):
    graph = Graph()
    name, shape, kind = encoder_input(layout)
    small = graph("AveragePool", normalised(graph, layout), kernel_shape=[4, 4], strides=[4, 4], name="/layers.1/local_conv/Conv" if mobile else None)
    widened(graph, graph("SpaceToDepth", small, blocksize=4), 256, 48, output)
    return graph.write(file, {name: (shape, kind)}, {output: ((1, 256, 64, 64), FLOAT)})


def sam2_encoder(file, layout="first"):
    graph = Graph()
    name, shape, kind = encoder_input(layout)
    small = graph("AveragePool", normalised(graph, layout), kernel_shape=[4, 4], strides=[4, 4])
    widened(graph, small, 32, 3, "high_res_feats_0")
    for output, channels, factor in (("high_res_feats_1", 64, 2), ("image_embed", 256, 4)):
        widened(graph, graph("AveragePool", small, kernel_shape=[factor] * 2, strides=[factor] * 2), channels, 3, output)
    shapes = {"high_res_feats_0": (1, 32, 256, 256), "high_res_feats_1": (1, 64, 128, 128), "image_embed": (1, 256, 64, 64)}
    return graph.write(file, {name: (shape, kind)}, {name: (shape, FLOAT) for name, shape in shapes.items()})


def masks_at_points(graph, colours):
    """Logits (points, 1, 256, 256) of what has the colour at each first point, and how red it is (points, 1), 0..1."""
    at = graph("Gather", "point_coords", graph.constant(0, np.int64), axis=1)
    place = graph("Floor", graph("Div", graph("Add", at, graph.constant(0.5)), graph.constant(4)))
    place = graph("Cast", graph("Clip", place, graph.constant(0), graph.constant(COARSE - 1)), to=LONG)
    row_first = graph("Gather", place, graph.constant([1, 0], np.int64), axis=1)
    rows_last = graph("Transpose", graph("Squeeze", colours, graph.constant([0], np.int64)), perm=[1, 2, 0])
    colour = graph("GatherND", rows_last, row_first)
    wide = graph("Unsqueeze", colour, graph.constant([2, 3], np.int64))
    apart = graph("ReduceSum", graph("Abs", graph("Sub", colours, wide)), graph.constant([1], np.int64), keepdims=1)
    logits = graph("Mul", graph("Sub", graph.constant(NEAR), apart), graph.constant(20))
    red = graph("Add", graph("Mul", colour, graph.constant(DEVIATION / 255)), graph.constant(MEAN / 255))
    return logits, graph("Gather", red, graph.constant([0], np.int64), axis=1)


def quality_of(graph, red, less):
    """0.9 + 0.1 * red, less `less` for each of the masks of a point."""
    best = graph("Add", graph("Mul", red, graph.constant(0.1)), graph.constant(0.9))
    return graph("Sub", best, graph.constant(np.asarray([less])))


def sam_decoder(file, points="one", masks=4):
    """points: "one": a batch of 1, as the official export has it; "many": open, and true; "mixed": open, but the second answer is wrong."""
    graph = Graph()
    count = 1 if points == "one" else "points"
    embedding = graph("Slice", "image_embeddings", graph.constant([0], np.int64), graph.constant([48], np.int64), graph.constant([1], np.int64))
    logits, red = masks_at_points(graph, graph("DepthToSpace", embedding, blocksize=4))
    if points == "mixed":  # all points are answered as the first
        first = graph("Slice", logits, graph.constant([0], np.int64), graph.constant([1], np.int64), graph.constant([0], np.int64))
        logits = graph("Add", graph("Mul", logits, graph.constant(0)), first)
    # Without the point that is none, whose label is -1, the decoder thinks nothing of its masks.
    last = graph("Gather", "point_labels", graph.constant([1], np.int64), axis=1)
    first = graph("Gather", "point_labels", graph.constant([0], np.int64), axis=1)
    asked = graph("Mul", graph("Neg", last), first)
    everything = graph("Add", graph("Abs", logits), graph.constant(5))
    if masks == 4:  # of several points; the thing; everything; nothing
        made = graph("Concat", everything, logits, everything, graph("Neg", everything), axis=1, output="low_res_masks")
        quality = quality_of(graph, red, [0, 0, 0.3, 0])
    else:
        made, quality = graph("Identity", logits, output="low_res_masks"), quality_of(graph, red, [0])
    graph("Mul", quality, asked, output="iou_predictions")
    size = graph("Cast", "orig_im_size", to=LONG)
    first_two = graph("Slice", graph("Shape", made), graph.constant([0], np.int64), graph.constant([2], np.int64))
    graph("Resize", made, "", "", graph("Concat", first_two, size, axis=0), output="masks", mode="linear")
    inputs = {
        "image_embeddings": ((1, 256, 64, 64), FLOAT),
        "point_coords": ((count, "num_points", 2), FLOAT),
        "point_labels": ((count, "num_points"), FLOAT),
        "mask_input": ((1, 1, 256, 256), FLOAT),
        "has_mask_input": ((1,), FLOAT),
        "orig_im_size": ((2,), FLOAT),
    }
    outputs = {"masks": ((count, masks, "h", "w"), FLOAT), "iou_predictions": ((count, masks), FLOAT), "low_res_masks": ((count, masks, 256, 256), FLOAT)}
    return graph.write(file, inputs, outputs)


def sam2_decoder(file):
    graph = Graph()
    colours = graph("Slice", "high_res_feats_0", graph.constant([0], np.int64), graph.constant([3], np.int64), graph.constant([1], np.int64))
    logits, red = masks_at_points(graph, colours)
    everything = graph("Add", graph("Abs", logits), graph.constant(5))
    graph("Concat", logits, everything, graph("Neg", everything), axis=1, output="masks")
    asked = graph("Gather", "point_labels", graph.constant([0], np.int64), axis=1)
    graph("Mul", quality_of(graph, red, [0, 0.3, 0]), asked, output="iou_predictions")
    inputs = {
        "image_embed": ((1, 256, 64, 64), FLOAT),
        "high_res_feats_0": ((1, 32, 256, 256), FLOAT),
        "high_res_feats_1": ((1, 64, 128, 128), FLOAT),
        "point_coords": (("num_labels", "num_points", 2), FLOAT),
        "point_labels": (("num_labels", "num_points"), FLOAT),
        "mask_input": (("num_labels", 1, 256, 256), FLOAT),
        "has_mask_input": (("num_labels",), FLOAT),
    }
    return graph.write(file, inputs, {"masks": (("num_labels", 3, 256, 256), FLOAT), "iou_predictions": (("num_labels", 3), FLOAT)})


def clip_image(file, batch="batch", width=3):
    graph = Graph()
    colour = graph("Flatten", graph("GlobalAveragePool", "pixel_values"))
    colour = graph("Add", graph("Mul", colour, graph.constant(COLOUR_DEVIATION)), graph.constant(COLOUR_MEAN))
    graph("MatMul", colour, graph.constant(np.eye(3, width)), output="image_embeds")
    return graph.write(file, {"pixel_values": ((batch, 3, 224, 224), FLOAT)}, {"image_embeds": ((batch, width), FLOAT)})


def clip_text(file, tokenizer, attention=True, length="length", output="text_embeds"):
    """And the tokenizer.json for it: a word is a token, and "beyond" one that the model does not have."""
    from tokenizers import Tokenizer, models, normalizers, pre_tokenizers, processors

    vocabulary = {"<|startoftext|>": 0, "<|endoftext|>": 1, "<unk>": 2} | {word: 3 + number for number, word in enumerate(WORDS)} | {"beyond": 99}
    made = Tokenizer(models.WordLevel(vocabulary, unk_token="<unk>"))
    made.normalizer, made.pre_tokenizer = normalizers.Lowercase(), pre_tokenizers.Whitespace()
    ends = [("<|startoftext|>", 0), ("<|endoftext|>", 1)]
    made.post_processor = processors.TemplateProcessing(single="<|startoftext|> $A <|endoftext|>", special_tokens=ends)
    made.save(str(tokenizer))
    graph = Graph()
    table = np.array([(0, 0, 0)] * 3 + list(WORDS.values()), np.float32)
    colours = graph("Gather", graph.constant(table), "input_ids")
    if attention:
        shares = graph("Unsqueeze", graph("Cast", "attention_mask", to=FLOAT), graph.constant([2], np.int64))
        colours = graph("Mul", colours, shares)
    graph("ReduceSum", colours, graph.constant([1], np.int64), keepdims=0, output=output)
    inputs = {name: (("batch", length), LONG) for name in ("input_ids", *(["attention_mask"] if attention else []))}
    return graph.write(file, inputs, {output: (("batch", 3), FLOAT)})


def cut_off(file, into):
    """The first half of a file."""
    content = file.read_bytes()
    into.write_bytes(content[: len(content) // 2])
    return str(into)


