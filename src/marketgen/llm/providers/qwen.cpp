// Qwen on Alibaba Cloud's Model Studio, in its mode that is compatible with OpenAI's chat
// completions:
// https://www.alibabacloud.com/help/en/model-studio/compatibility-of-openai-with-dashscope
#include "llm/provider.h"

namespace marketgen::llm {

net::HttpRequest qwen_request(const ProviderCall& call) {
  ProviderCall compatible = call;
  compatible.own_server = false;  // knows the older names of fields
  return openai_request(compatible);
}

Result<ChatAnswer> qwen_answer(std::string_view body, const std::string& where) {
  return openai_answer(body, where);
}

}  // namespace marketgen::llm
